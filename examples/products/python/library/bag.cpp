#include "bag.h"

#include <new>

using quadrille::internal::code_of;

extern "C" {

quadrille_bag* quadrille_bag_new(void) {
  return new (std::nothrow) quadrille_bag;
}

void quadrille_bag_delete(quadrille_bag* bag) {
  delete bag;
}

const char* quadrille_bag_error(const quadrille_bag* bag) {
  return bag->error.c_str();
}

int32_t quadrille_bag_put(quadrille_bag* bag, const char* name, const quadrille_array* array) {
  return code_of(bag->error, [&] { bag->given[name] = {name, *array}; });
}

size_t quadrille_bag_count(const quadrille_bag* bag) {
  return bag->answers.size();
}

const char* quadrille_bag_take(const quadrille_bag* bag, size_t index, quadrille_array* view) {
  *view = bag->answers[index].view;
  return bag->answers[index].name.c_str();
}

} // extern "C"
