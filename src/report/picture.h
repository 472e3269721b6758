#pragma once

#include <compare>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "src/report/outline.h"

namespace ricochet::report {

/// How outlines are painted; what is empty is SVG's default, but `fill`, which is none then.
struct Brush {
  std::string stroke = {}, width = {}, dash = {}, cap = {};
  std::string fill = {}, opacity = {};
  bool crisp = false;  ///< edges on whole pixels: neighbours leave no gap
  auto operator<=>(const Brush&) const = default;
};

/// What is painted by one brush, in the order of the outlines' brushes.
using Layer = std::vector<std::pair<Brush, std::vector<Outline>>>;

struct Writing {
  std::string fill = {}, size = {}, anchor = {}, weight = {};
  std::string turned = {};  ///< the transformation that places it, if it is not only moved
  Pixel place = {};
  std::string text = {};
  auto style() const { return std::tie(fill, size, anchor, weight); }
};

/// A bar that explains the colours of a heat map, from below to above.
struct ColourBar {
  Outline box;
  std::vector<std::string> colours;  ///< in even steps
};

/// What gnuplot's SVG shows, without how it says so.
struct Picture {
  std::vector<Layer> layers;  ///< the first: axes and grid; then one a plot, in painting order
  std::vector<Writing> writings;
  std::optional<ColourBar> bar;
  std::map<std::string, pugi::xml_node> patterns;  ///< that brushes fill with, by url(#id)
  int width = 0, height = 0;
};

/// Throws std::runtime_error where it shows what this does not know. The document must outlive the
/// picture.
Picture picture_of(const pugi::xml_document& document);

}  // namespace ricochet::report
