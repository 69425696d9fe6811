#ifndef QUADRILLE_EXAMPLES_BAG_H
#define QUADRILLE_EXAMPLES_BAG_H

#include "package.h"

#include <quadrille/c/arrays.h>
#include <quadrille/c/failures.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct quadrille_bag {
  struct Answer {
    std::string name;
    quadrille_array view;
    std::shared_ptr<const void> owner;
  };
  std::map<std::string, quadrille::internal::NamedArray, std::less<>> given;
  std::vector<Answer> answers;
  std::string error;

  // --- What was put in

  bool has(std::string_view name) const { return given.find(name) != given.end(); }
  const quadrille_array& array(std::string_view name) const {
    const auto found = given.find(name);
    if (found == given.end())
      throw std::invalid_argument("there is no " + std::string(name));
    return found->second.array;
  }
  /// Rows of n numbers, which are packed.
  template <class T, std::size_t n>
  std::span<const std::array<T, n>> rows(std::string_view name) const {
    const quadrille_array& a = array(name);
    return {static_cast<const std::array<T, n>*>(a.data), a.rows};
  }
  template <class T>
  std::span<const T> numbers(std::string_view name) const {
    const quadrille_array& a = array(name);
    return {static_cast<const T*>(a.data), a.rows * a.columns};
  }
  double number(std::string_view name) const { return numbers<double>(name)[0]; }
  bool flag(std::string_view name) const { return has(name) && number(name) != 0; }
  std::string text(std::string_view name) const {
    const auto bytes = numbers<std::uint8_t>(name);
    return {bytes.begin(), bytes.end()};
  }
  std::filesystem::path path(std::string_view name) const { return text(name); }
  /// Texts one after the other, with the place where each ends.
  std::vector<std::string> texts(const std::string& name) const {
    const std::string all = text(name);
    std::vector<std::string> result;
    std::size_t begin = 0;
    for (const std::uint64_t end : numbers<std::uint64_t>(name + ".ends")) {
      result.push_back(all.substr(begin, end - begin));
      begin = end;
    }
    return result;
  }

  // --- What is given back

  template <class T>
  void give(std::string name, std::vector<T> values, std::size_t columns = 1) {
    auto owner = std::make_shared<std::vector<T>>(std::move(values));
    const quadrille_array view = quadrille::internal::view_of(*owner, columns);
    answers.push_back({std::move(name), view, std::move(owner)});
  }
  template <class T, std::size_t n>
  void give(std::string name, std::vector<std::array<T, n>> values) {
    auto owner = std::make_shared<std::vector<std::array<T, n>>>(std::move(values));
    const quadrille_array view = quadrille::internal::view_of(*owner);
    answers.push_back({std::move(name), view, std::move(owner)});
  }
  void give_text(std::string name, std::string_view text) {
    give(std::move(name), std::vector<std::uint8_t>(text.begin(), text.end()));
  }
  void give_texts(const std::string& name, const std::vector<std::string>& texts) {
    std::string all;
    std::vector<std::int64_t> ends;
    for (const std::string& text : texts) {
      all += text;
      ends.push_back(static_cast<std::int64_t>(all.size()));
    }
    give_text(name, all);
    give(name + ".ends", std::move(ends));
  }
  template <class... Numbers>
  void give_numbers(std::string name, Numbers... values) {
    give(std::move(name), std::vector<double>{static_cast<double>(values)...});
  }
};

#endif
