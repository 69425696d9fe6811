#ifndef QUADRILLE_EXAMPLES_PAGE_PAGE_PARTS_H
#define QUADRILLE_EXAMPLES_PAGE_PAGE_PARTS_H

#include <array>
#include <string_view>

namespace quadrille_examples {

/// The viewer as UTF-8 HTML. Between its parts belong the title, the header (JSON) and the data
/// (base64). build.mjs makes them.
extern const std::array<std::string_view, 4> page_parts;

} // namespace quadrille_examples

#endif
