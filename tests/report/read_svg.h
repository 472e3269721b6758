#pragma once

#include <pugixml.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "src/report/svg.h"

namespace ricochet::report {

/// A path of an SVG picture, with the corners of all its lines.
struct ReadPath {
  pugi::xml_node node;
  std::vector<std::vector<Pixel>> lines;
};

/// The lines of path data of the commands M, m, l, h, v, a and z.
inline std::vector<std::vector<Pixel>> lines_in(const std::string& data) {
  std::vector<std::vector<Pixel>> lines;
  Pixel at{0, 0};
  char command = ' ';
  const char* next = data.c_str();
  const auto number = [&next] {
    char* end = nullptr;
    const double value = std::strtod(next, &end);
    if (end == next) throw std::runtime_error(std::string("no number: ") + next);
    next = end;
    while (*next == ' ') ++next;
    return value;
  };
  while (*next != '\0') {
    if (std::isalpha(static_cast<unsigned char>(*next)) != 0) command = *next++;
    if (command == 'z') {
      at = lines.back().front();
      continue;
    }
    if (command == 'a')
      for (int i = 0; i < 5; ++i) number();
    if (command == 'M') at = {0, 0};
    if (command != 'v') at.x += number();
    if (command != 'h') at.y += number();
    if (command == 'M' || command == 'm') {
      lines.emplace_back();
      command = 'l';
    }
    lines.back().push_back(at);
  }
  return lines;
}

/// A picture as it is read back. Throws std::runtime_error if it is no XML.
class ReadSvg {
 public:
  explicit ReadSvg(const std::string& svg) {
    const auto parsed = document_.load_string(svg.c_str());
    if (!parsed) throw std::runtime_error(std::string(parsed.description()) + " in " + svg);
  }

  pugi::xml_node root() const { return document_.child("svg"); }

  /// Those of which the attribute, of themselves or their group, has the value.
  std::vector<ReadPath> paths(const char* attribute, const std::string& value) const {
    std::vector<ReadPath> found;
    for (const pugi::xpath_node& one : document_.select_nodes("//path")) {
      const pugi::xml_node node = one.node();
      if (value != node.attribute(attribute).value() &&
          value != node.parent().attribute(attribute).value())
        continue;
      found.push_back({node, lines_in(node.attribute("d").value())});
    }
    return found;
  }

  std::size_t lines_of(const char* attribute, const std::string& value) const {
    std::size_t lines = 0;
    for (const ReadPath& path : paths(attribute, value)) lines += path.lines.size();
    return lines;
  }

  /// All texts, as a reader sees them, a line each.
  std::string text() const {
    std::string text;
    for (const pugi::xpath_node& one : document_.select_nodes("//text"))
      text += std::string(one.node().child_value()) + "\n";
    return text;
  }

  std::vector<std::string> ids() const {
    std::vector<std::string> ids;
    for (const pugi::xpath_node& one : document_.select_nodes("//@id"))
      ids.emplace_back(one.attribute().value());
    return ids;
  }

 private:
  pugi::xml_document document_;
};

}  // namespace ricochet::report
