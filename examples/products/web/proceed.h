#ifndef QUADRILLE_EXAMPLES_WEB_PROCEED_H
#define QUADRILLE_EXAMPLES_WEB_PROCEED_H

#include <quadrille/report.h>

#include <stdexcept>

/// A function that JavaScript sees, by that name.
#define QUADRILLE_EXPORT(name) __attribute__((export_name(#name)))

namespace quadrille_examples {

/// Is told how far a call is, as a Status has it. 0 ends the call with what has been done so far,
/// and a number below with nothing, since the function of the user's has thrown.
extern "C" __attribute__((import_module("quadrille"), import_name("proceed"))) int
proceed_in_javascript(double progress, double faces, double vertices, double contractions,
                      double next_error, double diagonal);

inline bool proceed(const quadrille::Status& status) {
  const int answer = proceed_in_javascript(
      status.progress, static_cast<double>(status.faces), static_cast<double>(status.vertices),
      static_cast<double>(status.contractions), status.next_error, status.diagonal);
  if (answer < 0)
    throw std::runtime_error("quadrille: the progress function threw an exception");
  return answer != 0;
}

} // namespace quadrille_examples

#endif
