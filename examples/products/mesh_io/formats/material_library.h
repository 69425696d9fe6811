#ifndef QUADRILLE_EXAMPLES_MATERIAL_LIBRARY_H
#define QUADRILLE_EXAMPLES_MATERIAL_LIBRARY_H

#include "../linear_light.h"
#include "../text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <sstream>
#include <string>

namespace quadrille_examples {

/// What the material of an OBJ file looks like, as far as it is read.
struct ObjMaterial {
  std::array<double, 3> color = {1, 1, 1}; ///< diffuse (Kd), in linear light
  double opacity = 1;                      ///< d, or what Tr leaves
  std::string image;                       ///< map_Kd: the name of a file; empty: none
  std::string normal_image;                ///< map_Bump, norm: the same
};

/// Reads materials of OBJ (.mtl): of each `newmtl` its colour, opacity and images.
class MaterialLibrary {
public:
  /// Adds those of a text; what is there already is changed.
  static void read(const std::string& content, std::map<std::string, ObjMaterial>& materials) {
    std::istringstream lines(content);
    ObjMaterial* material = nullptr;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "newmtl")
        material = &materials[rest(words)];
      else if (material)
        read(keyword, words, *material);
    }
  }

private:
  static void read(const std::string& keyword, std::istringstream& words, ObjMaterial& material) {
    double number = 0;
    if (keyword == "Kd")
      read_color(words, material);
    else if (keyword == "d" && words >> number)
      material.opacity = std::clamp(number, 0., 1.);
    else if (keyword == "Tr" && words >> number)
      material.opacity = 1 - std::clamp(number, 0., 1.);
    else if (keyword == "map_Kd")
      material.image = name_of_file(rest(words));
    else if (keyword == "norm" || keyword == "map_Kn")
      material.normal_image = name_of_file(rest(words));
  }

  static std::string rest(std::istringstream& words) {
    std::string text;
    std::getline(words >> std::ws, text);
    text.erase(std::find_if(text.rbegin(), text.rend(), [](char c) { return !is_blank(c); }).base(),
               text.end());
    return text;
  }

  static void read_color(std::istringstream& words, ObjMaterial& material) {
    std::array<double, 3> color{};
    if (words >> color[0] >> color[1] >> color[2])
      for (std::size_t i = 0; i < 3; ++i)
        material.color[i] = linear_light(std::clamp(color[i], 0., 1.));
  }

  /// Options before the name are passed over.
  static std::string name_of_file(std::string name) {
    if (name.starts_with('-'))
      name = name.substr(name.rfind(' ') + 1);
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
  }
};

} // namespace quadrille_examples

#endif
