// Functions of one argument as those of quadrille.h. A generator of Python answers, which cannot be
// entered twice: what several threads ask waits.
#include "package.h"

#include <mutex>
#include <new>

struct quadrille_functions {
  quadrille_asked asked;
  std::mutex mutex = {};
};

namespace {

template <class Answer, class View, Answer (*quadrille_asked::*member)(View)>
Answer ask(void* data, const View* view) {
  auto* const functions = static_cast<quadrille_functions*>(data);
  const std::lock_guard lock(functions->mutex);
  return (functions->asked.*member)(*view);
}

} // namespace

extern "C" {

quadrille_functions* quadrille_functions_new(quadrille_call* call, const quadrille_asked* asked) {
  auto* const functions = new (std::nothrow) quadrille_functions{*asked};
  if (!functions)
    return nullptr;
  if (asked->progress)
    quadrille_set_progress(call, ask<int32_t, quadrille_status, &quadrille_asked::progress>,
                           functions);
  if (asked->stop)
    quadrille_set_stop(call, ask<int32_t, quadrille_status, &quadrille_asked::stop>, functions);
  if (asked->filter)
    quadrille_set_filter(call, ask<int32_t, quadrille_contraction, &quadrille_asked::filter>,
                         functions);
  if (asked->cost)
    quadrille_set_cost(call, ask<double, quadrille_pair, &quadrille_asked::cost>, functions);
  return functions;
}

void quadrille_functions_delete(quadrille_functions* functions) {
  delete functions;
}

} // extern "C"
