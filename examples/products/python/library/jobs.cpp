// What the package calls by name.
#include "jobs.h"

#include "../../mesh_io/mesh/winding.h"

#include <quadrille/c/call.h>
#include <quadrille/c/report_members.h>
#include <quadrille/compiled/option_setting.h>
#include <quadrille/importance.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

void give_curvature(const Work& work) {
  const quadrille_bag& bag = work.bag;
  work.bag.give("importance", quadrille::curvature_importance(bag.rows<double, 3>("points"),
                                                              bag.rows<std::uint32_t, 3>("faces"),
                                                              {bag.number("strength")}));
}

void give_view(const Work& work) {
  const quadrille_bag& bag = work.bag;
  work.bag.give(
      "importance",
      quadrille::view_importance(
          bag.rows<double, 3>("points"), bag.rows<std::uint32_t, 3>("faces"),
          {{bag.rows<double, 3>("eye")[0]}, bag.number("turned_away"), bag.number("outline")}));
}

/// Which faces are wound against the others of their pieces, and how many pieces have but one side.
void give_winding(const Work& work) {
  const Winding winding(work.bag.rows<std::uint32_t, 3>("faces"),
                        static_cast<std::size_t>(work.bag.number("points")));
  const std::vector<bool>& is_against = winding.is_against();
  work.bag.give("against", std::vector<std::uint8_t>(is_against.begin(), is_against.end()));
  work.bag.give_numbers("one_sided", winding.one_sided());
}

using Job = void (*)(const Work&);

Job job_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Job>, 11> jobs{
      {{"read_mesh", read_file},
       {"write_mesh", write_file},
       {"surface_distance", measure_distance},
       {"verify", verify_result},
       {"simplify_gltf", simplify_document},
       {"curvature_importance", give_curvature},
       {"view_importance", give_view},
       {"winding", give_winding},
       {"hidden_faces", find_hidden},
       {"remove_hidden", remove_hidden},
       {"visibility", find_visibility}}};
  for (const auto& [known, job] : jobs)
    if (known == name)
      return job;
  throw std::invalid_argument("there is no job " + std::string(name));
}

} // namespace

void give_report(quadrille_bag& bag, const quadrille::Report& report) {
  bag.give_text("report", quadrille::internal::json_of(report));
}

#ifndef QUADRILLE_PYTHON_WITH_GLTF

bool is_gltf_file(std::string_view) {
  return false;
}
const MeshFormat& format_of_gltf() {
  throw std::runtime_error("this module was built without nlohmann_json, and knows no glTF");
}
IndexedMesh read_gltf_mesh(const std::filesystem::path&) {
  format_of_gltf();
  return {};
}
void write_gltf_mesh(const std::filesystem::path&, IndexedMesh&) {
  format_of_gltf();
}
void simplify_document(const Work&) {
  format_of_gltf();
}

#endif

} // namespace quadrille_examples

namespace {

template <class Options>
void set_unchecked(Options& options, const char* name, double value) {
  using namespace quadrille::internal;
  const bool is_known = with_option(options, name, [&](const Option& option, auto& field) {
    using Value = OptionValue<std::remove_reference_t<decltype(field)>>;
    if constexpr (std::is_arithmetic_v<Value>)
      field = static_cast<Value>(value);
    else
      reject_kind(option, "a number");
  });
  if (!is_known)
    reject_option(name);
}

} // namespace

extern "C" int32_t quadrille_set_unchecked(quadrille_call* call, int64_t channel, const char* name,
                                           double value) {
  return quadrille::internal::code_of(call->error, [&] {
    if (channel < 0)
      set_unchecked(call->job, name, value);
    else
      set_unchecked(call->channel(static_cast<std::size_t>(channel)).options, name, value);
  });
}

extern "C" int32_t quadrille_do(const char* name, quadrille_bag* bag, quadrille_call* call,
                                quadrille_part_function progress) {
  return quadrille::internal::code_of(bag->error, [&] {
    quadrille_examples::job_of(name)(quadrille_examples::Work{*bag, call, progress});
  });
}
