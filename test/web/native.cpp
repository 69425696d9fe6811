// What the package in JavaScript is compared with: simplifies a mesh by quadrille::compiled as it
// is built for this machine, and writes what goes in and what comes out, array by array.
//   native MODEL FOLDER [OPTION=VALUE]... [CHANNEL.OPTION=VALUE]... [levels=COUNT,COUNT]
// Channels are those that the model has: uv, normals, colors. Options are named as fields of
// SoupOptions and ChannelOptions. `without=uv,labels` leaves these out; `fixed=N` and `selected=N`
// take every N-th. It prints a line for each channel: its name, kind and number of components.

#include "../../examples/products/mesh_io/attributes/face_labels.h"
#include "../../examples/products/mesh_io/mesh_io.h"
#include "../../examples/products/web/call.h"
#include "../../examples/products/web/options.h"

#include <quadrille/levels.h>
#include <quadrille/stop.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

using namespace quadrille_examples;

namespace {

using Kind = quadrille::SoupChannelView::Kind;

struct Asked {
  std::string folder;
  Call call;
  std::vector<std::string> channel_names;
  std::vector<std::size_t> levels;
  std::string without = ",";
};

void write(const Asked& asked, const std::string& name, const ArrayView& view, std::size_t size) {
  std::ofstream file(asked.folder + '/' + name, std::ios::binary);
  file.write(static_cast<const char*>(view.begin), static_cast<std::streamsize>(view.count * size));
  if (!file.flush())
    throw std::runtime_error("cannot write " + name);
}
void write_reals(const Asked& asked, const std::string& name, const ArrayView& view) {
  write(asked, name, view, sizeof(double));
}
void write_integers(const Asked& asked, const std::string& name, const ArrayView& view) {
  write(asked, name, view, sizeof(std::uint32_t));
}

bool is_wanted(const Asked& asked, const std::string& name) {
  return asked.without.find(',' + name + ',') == std::string::npos;
}

template <std::size_t N>
void add_corners(Asked& asked, const std::string& name, Kind kind, const CornerValues<N>& corners) {
  if (corners.empty() || !is_wanted(asked, name))
    return;
  CallChannel channel{kind, N, {}, corners.triples, {}};
  for (const auto& value : corners.values)
    channel.values.insert(channel.values.end(), value.begin(), value.end());
  asked.call.channels.push_back(channel);
  asked.channel_names.push_back(name);
}

void take(Asked& asked, const IndexedMesh& mesh) {
  for (const Point& p : mesh.points)
    asked.call.positions.push_back({p.x(), p.y(), p.z()});
  asked.call.indices = mesh.triangles;
  if (is_wanted(asked, "labels"))
    asked.call.labels = FaceRegions(mesh).labels();
  add_corners(asked, "uv", Kind::texture, mesh.corner_textures);
  add_corners(asked, "normals", Kind::normals, mesh.corner_normals);
  if (!mesh.texture_coordinates.empty() && is_wanted(asked, "uv")) {
    CallChannel channel{Kind::texture, 2, {}, {}, {}};
    for (const auto& value : mesh.texture_coordinates)
      channel.values.insert(channel.values.end(), value.begin(), value.end());
    asked.call.channels.push_back(channel);
    asked.channel_names.push_back("uv");
  }
  if (mesh.colors.empty() || !is_wanted(asked, "colors"))
    return;
  CallChannel channel{Kind::colors, 3, {}, {}, {}};
  for (const Color& color : mesh.colors)
    channel.values.insert(channel.values.end(), color.begin(), color.begin() + 3);
  asked.call.channels.push_back(channel);
  asked.channel_names.push_back("colors");
}

/// Sets what is a number, or else chosen by its name.
template <class Options_>
void set(Options_& options, const std::string& name, const std::string& value) {
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  if (*end == '\0')
    set_number(options, name, number);
  else
    set_choice(options, name, value);
}

void set_of_channel(Asked& asked, const std::string& channel, const std::string& name,
                    const std::string& value) {
  for (std::size_t c = 0; c < asked.channel_names.size(); ++c)
    if (asked.channel_names[c] == channel)
      return set(asked.call.channels[c].options, name, value);
  throw std::invalid_argument("there is no channel " + channel);
}

std::vector<std::uint8_t> each(std::size_t count, const std::string& step) {
  std::vector<std::uint8_t> mask(count);
  for (std::size_t i = 0; i < count; i += std::stoul(step))
    mask[i] = 1;
  return mask;
}

void set(Asked& asked, const std::string& word) {
  const std::size_t equals = word.find('='), dot = word.substr(0, equals).find('.');
  const std::string name = word.substr(0, equals), value = word.substr(equals + 1);
  if (name == "levels") {
    std::istringstream counts(value);
    for (std::string count; std::getline(counts, count, ',');)
      asked.levels.push_back(std::stoul(count));
  } else if (name == "fixed") {
    asked.call.fixed = each(asked.call.positions.size(), value);
  } else if (name == "selected") {
    asked.call.selected = each(asked.call.indices.size(), value);
  } else if (dot != std::string::npos) {
    set_of_channel(asked, name.substr(0, dot), name.substr(dot + 1), value);
  } else if (name != "without") {
    set(asked.call.options, name, value);
  }
}

template <class Output>
void write_output(const Asked& asked, const std::string& prefix, const Output& output) {
  write_reals(asked, prefix + "positions", view_of_output(output, "positions", 0));
  for (const char* name : {"indices", "inputFaces"})
    write_integers(asked, prefix + name, view_of_output(output, name, 0));
  for (std::size_t c = 0; c < asked.channel_names.size(); ++c) {
    const std::string name = prefix + asked.channel_names[c];
    write_reals(asked, name + ".values", view_of_output(output, "values", c));
    write_integers(asked, name + ".indices", view_of_output(output, "corners", c));
  }
}

void write_input(const Asked& asked) {
  write_reals(asked, "in.positions", view_of(asked.call.positions));
  write_integers(asked, "in.indices", view_of(asked.call.indices));
  write_integers(asked, "in.labels", view_of(asked.call.labels));
  for (std::size_t c = 0; c < asked.channel_names.size(); ++c) {
    const CallChannel& channel = asked.call.channels[c];
    write_reals(asked, "in." + asked.channel_names[c] + ".values", view_of(channel.values));
    write_integers(asked, "in." + asked.channel_names[c] + ".indices", view_of(channel.triangles));
    for (const auto& [name, kind] : kinds)
      if (kind == channel.kind)
        std::cout << asked.channel_names[c] << ' ' << name << ' ' << channel.components << '\n';
  }
}

void run(int argc, char** argv) {
  Asked asked;
  asked.folder = argv[2];
  for (int i = 3; i < argc; ++i)
    if (std::string_view word = argv[i]; word.starts_with("without="))
      asked.without += std::string(word.substr(8)) + ',';
  take(asked, read_mesh(argv[1]));
  for (int i = 3; i < argc; ++i)
    set(asked, argv[i]);
  write_input(asked);
  quadrille::Levels levels;
  asked.call.run(asked.levels.empty() ? nullptr : &levels);
  write_output(asked, "out.", asked.call.result);
  write_integers(asked, "out.labels", view_of(asked.call.result.labels));
  for (const std::size_t count : asked.levels)
    write_output(asked, "level." + std::to_string(count) + '.',
                 levels.at(quadrille::FaceCount{count}));
}

} // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 3)
      throw std::invalid_argument("native MODEL FOLDER [OPTION=VALUE]...");
    run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
