#ifndef QUADRILLE_INTERNAL_TEXT_H
#define QUADRILLE_INTERNAL_TEXT_H

#include <sstream>
#include <string>

namespace quadrille::internal {

/// A number for a message. std::to_string would write "-0.000000" for -1e-300.
inline std::string text_of(double x) {
  std::ostringstream out;
  out << x;
  return out.str();
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_TEXT_H
