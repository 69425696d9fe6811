// What worker.js of the page calls: reads files, records levels of them, and writes files, all in
// the memory of the module. None of the functions throws.

#include "../call.h"
#include "../json.h"
#include "../proceed.h"
#include "session.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <string>

namespace quadrille_examples {

namespace {

struct PageCall {
  Call answers; // its text and view
  PageSession session;
  PageContent content; // recorded last
  std::string file;    // saved last
};

PageSession::Choices choices(std::size_t faces, double relative_error, bool keeps_seams,
                             bool is_accurate) {
  using Cost = quadrille::SoupOptions::Cost;
  PageSession::Choices choices{faces, {}, keeps_seams, {}};
  if (relative_error < std::numeric_limits<double>::infinity())
    choices.relative_error = relative_error;
  choices.cost = is_accurate ? Cost::memoryless_quadric : Cost::quadric;
  return choices;
}

const ArrayView* view_of_bytes(Call& answers, const std::string& bytes) {
  answers.view = {bytes.data(), static_cast<std::uint32_t>(bytes.size())};
  return &answers.view;
}

} // namespace

extern "C" {

QUADRILLE_EXPORT(newPage) PageCall* new_page() {
  return new (std::nothrow) PageCall;
}
/// Room for a text of so many bytes, which the next function reads.
QUADRILLE_EXPORT(textRoom) char* text_room(PageCall* page, std::size_t bytes) {
  Call& answers = page->answers;
  return answers.succeeds([&] { answers.text.assign(bytes, ' '); }) ? answers.text.data() : nullptr;
}
/// The text is the name of a file, of so many bytes, and its content behind it.
QUADRILLE_EXPORT(openFile) bool open_file(PageCall* page, std::size_t name_size) {
  return page->answers.succeeds([&] {
    const std::string name = page->answers.text.substr(0, name_size);
    std::string content = std::move(page->answers.text);
    content.erase(0, name_size);
    page->session.open(name, std::move(content));
  });
}
QUADRILLE_EXPORT(hasTexture) bool has_texture(PageCall* page) {
  return page->session.has_texture();
}
QUADRILLE_EXPORT(record)
bool record(PageCall* page, double relative_error, bool keeps_seams, bool is_accurate) {
  return page->answers.succeeds([&] {
    const auto chosen = choices(4, relative_error, keeps_seams, is_accurate);
    page->content = page->session.record(chosen, proceed);
    page->answers.text = json_of(page->session.report());
  });
}
/// The text is the extension.
QUADRILLE_EXPORT(saveFile)
bool save_file(PageCall* page, std::size_t faces, double relative_error, bool keeps_seams,
               bool is_accurate) {
  return page->answers.succeeds([&] {
    const std::string extension = page->answers.text;
    const auto chosen = choices(faces, relative_error, keeps_seams, is_accurate);
    page->file = page->session.save(chosen, extension, proceed);
    page->answers.text = json_of(page->session.report());
  });
}
/// A report, or what was wrong.
QUADRILLE_EXPORT(pageText) const ArrayView* page_text(PageCall* page) {
  return view_of_bytes(page->answers, page->answers.text);
}
QUADRILLE_EXPORT(pageHeader) const ArrayView* page_header(PageCall* page) {
  return view_of_bytes(page->answers, page->content.header);
}
QUADRILLE_EXPORT(pageData) const ArrayView* page_data(PageCall* page) {
  return view_of_bytes(page->answers, page->content.data.bytes());
}
QUADRILLE_EXPORT(savedFile) const ArrayView* saved_file(PageCall* page) {
  return view_of_bytes(page->answers, page->file);
}

} // extern "C"

} // namespace quadrille_examples
