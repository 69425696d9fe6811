#ifndef QUADRILLE_INTERNAL_VERIFY_MATCHED_COMPONENTS_H
#define QUADRILLE_INTERNAL_VERIFY_MATCHED_COMPONENTS_H

#include <quadrille/internal/verify/solid_components.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Matches the components of two solids, some of which lie inside others: which component has
/// become which?
///
/// They are matched by position: the two nearest unmatched components are matched first, and so on.
/// If components lie close together, like the shells of an onion, and have been changed by more
/// than the distance between them, this is unreliable. So if a matching exists in which every
/// component keeps its handles, its orientation and its nesting, and its distances are hardly
/// greater, that matching is the answer.
class MatchedComponents {
public:
  MatchedComponents(const std::vector<SolidComponent>& before,
                    const std::vector<SolidComponent>& after)
      : before_(before), after_(after) {}

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// Returns, for each component before, the component after that it has become, or none.
  std::vector<std::size_t> match() {
    std::vector<std::size_t> by_place(before_.size(), none);
    match_nearest(all(before_), all(after_), by_place);
    const std::optional<std::vector<std::size_t>> alike = matched_alike();
    return alike && distance(*alike) <= hardly_further * distance(by_place) ? *alike : by_place;
  }

private:
  using Numbers = std::vector<std::size_t>;
  static constexpr double hardly_further = 1.5;

  /// The kind of a component is what it has to keep: its handles, its orientation, and the kinds of
  /// the components that lie in it.
  using Kind = std::tuple<std::ptrdiff_t, int, Numbers>;
  using Kinds = std::map<Kind, std::size_t>;
  struct Forest {
    Numbers kinds;
    std::vector<Numbers> children; ///< for each component, and at the end for none
  };

  static Numbers all(const std::vector<SolidComponent>& components) {
    Numbers numbers(components.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return numbers;
  }

  double distance(std::size_t i, std::size_t j) const {
    return before_[i].shape.apart(after_[j].shape);
  }
  double distance(const Numbers& matches) const {
    double sum = 0;
    for (std::size_t i = 0; i < matches.size(); ++i)
      if (matches[i] != none)
        sum += distance(i, matches[i]);
    return sum;
  }

  /// Works in rounds: two components that are nearest to each other are so among all, too.
  void match_nearest(Numbers left, Numbers right, Numbers& matches) const {
    while (!left.empty() && !right.empty()) {
      Numbers of_left(left.size()), of_right(right.size());
      for (std::size_t i = 0; i < left.size(); ++i)
        of_left[i] = nearest(right, [&](std::size_t j) { return distance(left[i], j); });
      for (std::size_t j = 0; j < right.size(); ++j)
        of_right[j] = nearest(left, [&](std::size_t i) { return distance(i, right[j]); });
      Numbers rest, rest_of_right;
      for (std::size_t i = 0; i < left.size(); ++i)
        if (of_right[of_left[i]] == i)
          matches[left[i]] = right[of_left[i]];
        else
          rest.push_back(left[i]);
      for (std::size_t j = 0; j < right.size(); ++j)
        if (of_left[of_right[j]] != j)
          rest_of_right.push_back(right[j]);
      left = std::move(rest);
      right = std::move(rest_of_right);
    }
  }

  template <class Distance>
  static std::size_t nearest(const Numbers& to, Distance distance) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < to.size(); ++i)
      if (const double d = distance(to[i]); d < least) {
        least = d;
        best = i;
      }
    return best;
  }

  /// Each component lies in the innermost of those around it.
  static Forest forest(const std::vector<SolidComponent>& components, Kinds& kinds) {
    const auto depth = [&](std::size_t i) { return components[i].around.size(); };
    Forest result{Numbers(components.size()), std::vector<Numbers>(components.size() + 1)};
    Numbers deepest_first = all(components);
    std::stable_sort(deepest_first.begin(), deepest_first.end(),
                     [&](std::size_t a, std::size_t b) { return depth(a) > depth(b); });
    for (const std::size_t i : deepest_first) {
      const Numbers& around = components[i].around;
      const auto parent = std::max_element(around.begin(), around.end(),
                                           [&](auto a, auto b) { return depth(a) < depth(b); });
      result.children[parent == around.end() ? components.size() : *parent].push_back(i);
      Numbers inside;
      for (const std::size_t child : result.children[i])
        inside.push_back(result.kinds[child]);
      std::sort(inside.begin(), inside.end());
      const Kind kind(components[i].euler_number, components[i].shape.orientation(),
                      std::move(inside));
      result.kinds[i] = kinds.try_emplace(kind, kinds.size()).first->second;
    }
    return result;
  }

  /// Matches from the outermost inward; components of one kind are matched by position. Returns
  /// nothing if that is impossible.
  std::optional<Numbers> matched_alike() const {
    Kinds kinds;
    const Forest left = forest(before_, kinds), right = forest(after_, kinds);
    Numbers matches(before_.size(), none);
    std::vector<std::pair<std::size_t, std::size_t>> parents{{before_.size(), after_.size()}};
    while (!parents.empty()) {
      const auto [a, b] = parents.back();
      parents.pop_back();
      const auto of_left = by_kind(left, a), of_right = by_kind(right, b);
      for (const auto& [kind, numbers] : of_left) {
        const auto other = of_right.find(kind);
        if (other == of_right.end() || other->second.size() != numbers.size())
          return std::nullopt;
        match_nearest(numbers, other->second, matches);
        for (const std::size_t i : numbers)
          parents.emplace_back(i, matches[i]);
      }
      if (of_left.size() != of_right.size())
        return std::nullopt;
    }
    return matches;
  }
  static std::map<std::size_t, Numbers> by_kind(const Forest& forest, std::size_t parent) {
    std::map<std::size_t, Numbers> result;
    for (const std::size_t child : forest.children[parent])
      result[forest.kinds[child]].push_back(child);
    return result;
  }

  const std::vector<SolidComponent>& before_;
  const std::vector<SolidComponent>& after_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_MATCHED_COMPONENTS_H
