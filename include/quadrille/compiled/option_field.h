#ifndef QUADRILLE_COMPILED_OPTION_FIELD_H
#define QUADRILLE_COMPILED_OPTION_FIELD_H

#include <optional>

namespace quadrille::internal {

/// The type of a field, without std::optional.
template <class Field>
struct OptionField {
  using Value = Field;
};
template <class Field>
struct OptionField<std::optional<Field>> {
  using Value = Field;
};
template <class Field>
using OptionValue = typename OptionField<Field>::Value;

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_OPTION_FIELD_H
