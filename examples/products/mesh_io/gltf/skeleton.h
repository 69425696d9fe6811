#ifndef QUADRILLE_EXAMPLES_GLTF_SKELETON_H
#define QUADRILLE_EXAMPLES_GLTF_SKELETON_H

#include "../text.h"
#include "accessor.h"
#include "document.h"
#include "json.h"
#include "transform.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille_examples {

/// The joints of a skin, and the poses in which a surface that they move is looked at: in each of
/// three, all joints below the first one turn about an axis of the mesh's space.
class GltfSkeleton {
public:
  static constexpr std::size_t poses = 3;

  /// `parents` are those of all nodes.
  GltfSkeleton(const GltfDocument& document, std::size_t skin,
               const std::vector<std::size_t>& parents) {
    const Json& json = element_of(document.json, "skins", skin);
    std::map<std::size_t, std::size_t> numbers; // of joints, by nodes
    for (std::size_t i = 0; i < size_of(json, "joints"); ++i) {
      const Json& joint = json["joints"][i];
      if (!joint.is_number_integer() || joint < 0 || joint >= parents.size())
        throw std::runtime_error("a joint of a skin is not a node");
      nodes_.push_back(joint.get<std::size_t>());
      numbers.emplace(nodes_.back(), i);
    }
    read_binds(document, json);
    find_parents(parents, numbers);
    find_turns();
  }

  std::size_t size() const { return nodes_.size(); }

  /// Where the first joint has the mesh as its nodes are now.
  Transform place(const std::vector<Transform>& worlds) const {
    return nodes_.empty() ? Transform() : worlds[nodes_.front()] * binds_.front();
  }

  /// How far a joint moves a point in a pose.
  Vector displacement(std::size_t joint, std::size_t pose, const Vector& point) const {
    Vector result = turns_[joint][pose](point);
    for (std::size_t i = 0; i < 3; ++i)
      result[i] -= point[i];
    return result;
  }

private:
  static constexpr auto none = static_cast<std::size_t>(-1);

  void read_binds(const GltfDocument& document, const Json& skin) {
    binds_.resize(nodes_.size());
    if (!member(skin, "inverseBindMatrices") || nodes_.empty())
      return;
    const Json& accessor =
        element_of(document.json, "accessors", count_of(skin, "inverseBindMatrices"));
    constexpr std::size_t size = 16 * sizeof(float);
    const std::string bytes = packed_elements(document, accessor, size, nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      std::array<double, 16> numbers{};
      for (std::size_t k = 0; k < numbers.size(); ++k)
        numbers[k] = double{little_endian_at<float>(bytes, i * size + k * sizeof(float))};
      binds_[i] = Transform::of_matrix(numbers);
    }
  }

  /// The next joint above each.
  void find_parents(const std::vector<std::size_t>& parents,
                    const std::map<std::size_t, std::size_t>& numbers) {
    parents_.assign(nodes_.size(), none);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (std::size_t node = parents[nodes_[i]]; node != none; node = parents[node])
        if (const auto found = numbers.find(node); found != numbers.end()) {
          parents_[i] = found->second;
          break;
        }
  }

  /// How many joints are above each.
  std::vector<std::size_t> depths() const {
    std::vector<std::size_t> depths(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (std::size_t joint = parents_[i]; joint != none; joint = parents_[joint])
        ++depths[i];
    return depths;
  }

  /// Of the joints on the longest way through each that turn.
  std::vector<std::size_t> chains(const std::vector<std::size_t>& depths, bool turns_roots) const {
    std::vector<std::size_t> longest(nodes_.size(), 1);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (std::size_t joint = i; joint != none; joint = parents_[joint])
        longest[joint] = std::max(longest[joint], depths[i] + turns_roots);
    return longest;
  }

  /// A chain of joints bends by a right angle as a whole, but each joint by what is usual.
  static double angle(std::size_t chain) {
    constexpr double right = std::numbers::pi / 2;
    return std::max(right / static_cast<double>(chain), right / 3);
  }

  /// Joints that are above others come first.
  void find_turns() {
    const bool turns_roots = std::count(parents_.begin(), parents_.end(), none) > 1;
    const std::vector<std::size_t> depths = this->depths(),
                                   chains = this->chains(depths, turns_roots);
    std::vector<std::size_t> order(nodes_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return depths[a] < depths[b]; });
    turns_.resize(nodes_.size());
    for (const std::size_t joint : order) {
      const Vector place = binds_[joint].inverse().value_or(Transform())({});
      for (std::size_t pose = 0; pose < poses; ++pose) {
        if (parents_[joint] != none)
          turns_[joint][pose] = turns_[parents_[joint]][pose];
        if (parents_[joint] != none || turns_roots)
          turns_[joint][pose] =
              turns_[joint][pose] * Transform::turn(pose, angle(chains[joint]), place);
      }
    }
  }

  std::vector<std::size_t> nodes_;   // the joints
  std::vector<Transform> binds_;     // from the mesh to each joint
  std::vector<std::size_t> parents_; // joints
  std::vector<std::array<Transform, poses>> turns_;
};

} // namespace quadrille_examples

#endif
