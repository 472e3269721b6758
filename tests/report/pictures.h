#pragma once

#include <pugixml.hpp>

#include "src/report/chart.h"
#include "src/report/svg.h"
#include "src/report/text.h"
#include "tests/support/test.h"

/// Charts for tests, and their pictures as they are read back.
namespace ricochet::report {

/// How a failed test names its chart.
inline void PrintTo(const Chart& chart, std::ostream* stream) {
  *stream << "chart " << chart.name << ", " << chart.title;
}

/// The chart after a change.
template <class Change>
Chart changed(Chart chart, const Change& change) {
  change(chart);
  return chart;
}

/// A curve that is called "path".
inline Chart line_chart(const std::vector<Sample>& samples) {
  return {.name = "chart",
          .title = "A title",
          .x = {.label = "time [s]"},
          .y = {.label = "x [mm]"},
          .series = {{"path", Mark::line, samples}}};
}

using Cells = std::vector<std::vector<std::optional<double>>>;

inline Chart heat_map_chart(const Cells& rows) {
  Chart chart{
      .name = "map", .title = "A map", .x = {.label = "restitution"}, .y = {.label = "friction"}};
  for (std::size_t i = 0; i < rows.size(); ++i) chart.y.categories.push_back(fmt::format("r{}", i));
  for (std::size_t i = 0; i < rows[0].size(); ++i)
    chart.x.categories.push_back(fmt::format("c{}", i));
  chart.heat_map = HeatMap{"threshold [rad/s]", rows};
  return chart;
}

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

/// A text and where it is drawn, about, in the font that text_width() knows.
struct ReadText {
  std::string text;
  double width;  ///< pixels, along the text
  Box box;
};

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
      if (value == node.attribute(attribute).value() ||
          value == node.parent().attribute(attribute).value())
        found.push_back({node, lines_in(node.attribute("d").value())});
    }
    return found;
  }

  /// All texts, as a reader sees them, a line each.
  std::string text() const {
    std::string all;
    for (const ReadText& one : texts()) all += one.text + "\n";
    return all;
  }

  std::vector<ReadText> texts() const {
    std::vector<ReadText> found;
    for (const pugi::xpath_node& one : document_.select_nodes("//text")) {
      const pugi::xml_node node = one.node(), group = node.parent();
      const double size = group.attribute("font-size").as_double(12);
      const double bold = group.attribute("font-weight") ? 1.14 : 1;
      ReadText text{
          node.child_value(), bold * text_width(node.child_value(), size), {1e9, -1e9, 1e9, -1e9}};
      double x = node.attribute("x").as_double(), y = node.attribute("y").as_double(), turned = 0;
      std::sscanf(node.attribute("transform").value(), "translate(%lf,%lf)rotate(%lf)", &x, &y,
                  &turned);
      turned *= std::numbers::pi / 180;
      const std::string anchor = group.attribute("text-anchor").value();
      const double before = anchor == "middle" ? text.width / 2 : anchor == "end" ? text.width : 0;
      for (const double along : {-before, text.width - before}) {
        for (const double down : {-0.75 * size, 0.22 * size}) {
          const double right = x + along * std::cos(turned) - down * std::sin(turned);
          const double below = y + along * std::sin(turned) + down * std::cos(turned);
          text.box = {std::min(text.box.left, right), std::max(text.box.right, right),
                      std::min(text.box.top, below), std::max(text.box.bottom, below)};
        }
      }
      found.push_back(text);
    }
    return found;
  }

  /// What is wrong with the texts: those that leave the picture, and those that are shortened
  /// though they are not very long. A line each.
  std::string cut_texts() const {
    std::string cut;
    const double width = root().attribute("width").as_double();
    const double height = root().attribute("height").as_double();
    for (const auto& [text, length, box] : texts()) {
      const double beyond = std::max({-box.left, box.right - width, -box.top, box.bottom - height});
      if (beyond > 1) cut += text + ": leaves the picture by " + std::to_string(beyond) + "\n";
      if (text.ends_with("…") && length < 400) cut += text + ": is shortened\n";
    }
    return cut;
  }

 private:
  pugi::xml_document document_;
};

}  // namespace ricochet::report
