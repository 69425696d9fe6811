#ifndef QUADRILLE_EXAMPLES_WEB_PAGE_SESSION_H
#define QUADRILLE_EXAMPLES_WEB_PAGE_SESSION_H

#include "../../mesh_io/attributes/mesh_channels.h"
#include "../../mesh_io/mesh/split_seams.h"
#include "../../mesh_io/mesh_io.h"
#include "../../page/attribute_recorder.h"
#include "../../page/file.h"
#include "document.h"

#include <quadrille/compiled.h>
#include <quadrille/record.h>
#include <quadrille/report.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille_examples {

/// A file that a page has been given, and what becomes of it there.
class PageSession {
public:
  /// What is chosen in the page.
  struct Choices {
    std::size_t faces = 4;                ///< at most so many
    std::optional<double> relative_error; ///< a part of the diagonal
    bool keeps_seams = false;             ///< all charts of a texture stay
    quadrille::SoupOptions::Cost cost = quadrille::SoupOptions::Cost::quadric;
  };

  /// Reads a file; its extension tells the format. Throws std::runtime_error with one line.
  void open(const std::string& name, std::string content) {
    Source source{name, std::move(content)};
    std::optional<PageDocument> document;
    if (is_gltf(source.path.extension().string()))
      document.emplace(std::move(source));
    ShownMesh shown = document ? document->shown() : shown_of_mesh(source);
    if (shown.mesh.triangles.empty())
      throw std::runtime_error(name + ": it has no faces");
    name_ = name;
    shown_ = std::move(shown);
    document_ = std::move(document);
  }

  /// Simplifies as far as it goes, and returns all levels of that as the viewer has them.
  PageContent record(const Choices& choices, const auto& proceed) {
    PageSource source;
    source.name = name_;
    source.looks = shown_.looks;
    AttributeRecorder recorder(shown_, source.levels);
    IndexedMesh mesh = shown_.mesh;
    quadrille::SoupOptions options = options_of(choices, proceed);
    options.recorder = quadrille::record_into(recorder);
    report_ = simplified(mesh, choices, options);
    source.attributes = recorder.take();
    return page_content(source);
  }

  /// A simplified mesh as a file of an extension. A document that becomes one keeps all that it
  /// has.
  std::string save(const Choices& choices, const std::string& extension, const auto& proceed) {
    const quadrille::SoupOptions options = options_of(choices, proceed);
    if (document_ && is_gltf(extension))
      return document_->simplified(options, channels_of(choices), shown_.mesh.triangles.size(),
                                   extension, report_);
    IndexedMesh mesh = document_ ? document_->mesh() : shown_.mesh;
    report_ = simplified(mesh, choices, options);
    if (is_gltf(extension))
      return encoded_document(name_, mesh, extension);
    const MeshFormat& format = mesh_format("out" + extension);
    fit_to_format(mesh, format);
    return encoded(name_, mesh, format);
  }

  /// Of what was done last.
  const quadrille::Report& report() const { return report_; }
  /// Has it a texture, whose seams may be kept?
  bool has_texture() const {
    return !shown_.mesh.texture_coordinates.empty() || !shown_.mesh.corner_textures.empty();
  }

private:
  static ShownMesh shown_of_mesh(const Source& source) {
    ShownMesh shown;
    shown.mesh =
        with_vertices_of_values(read_mesh(source, mesh_format(source.path, " .gltf .glb")));
    shown.looks.notes = shown.mesh.remarks;
    if (!shown.mesh.losses.empty())
      shown.looks.notes.push_back("Not kept: " + shown.mesh.losses.text());
    return shown;
  }

  static quadrille::SoupOptions options_of(const Choices& choices, const auto& proceed) {
    quadrille::SoupOptions options;
    options.faces = choices.faces;
    options.relative_error = choices.relative_error;
    options.cost = choices.cost;
    options.proceed = proceed;
    return options;
  }

  static ChannelChoices channels_of(const Choices& choices) {
    ChannelChoices channels;
    channels.of_numbers = 1. / 64; // they may be noise
    if (choices.keeps_seams)
      channels.texture_seams = quadrille::Seams::kept;
    return channels;
  }

  static quadrille::Report simplified(IndexedMesh& mesh, const Choices& choices,
                                      const quadrille::SoupOptions& options) {
    return MeshChannels(mesh).simplify(options, channels_of(choices));
  }

  std::string name_;
  ShownMesh shown_;
  std::optional<PageDocument> document_; // if it is one
  quadrille::Report report_;
};

} // namespace quadrille_examples

#endif
