#include "src/report/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace ricochet::report {
namespace {

constexpr int palette_steps = 5;  // between the colours of look.h's palette, which are even

std::string colour_of(const std::string& text) {
  unsigned red = 0, green = 0, blue = 0;
  if (std::sscanf(text.c_str(), "rgb(%u,%u,%u)", &red, &green, &blue) != 3) return text;
  return fmt::format("#{:02x}{:02x}{:02x}", red, green, blue);
}

/// A number without needless zeros.
std::string short_number(const std::string& text) {
  return text.empty() ? text : fmt::format("{:g}", std::strtod(text.c_str(), nullptr));
}

/// Pairs of numbers between commands M, L and Z, or without any.
std::vector<Outline> outlines_of(const std::string& data) {
  std::vector<Outline> outlines;
  const char* at = data.c_str();
  while (*at != '\0') {
    if (*at == 'M' || *at == 'm') outlines.emplace_back();
    if (*at == 'Z' || *at == 'z') outlines.back().closed = true;
    if (std::string_view("MmLlZz ,\n\t").find(*at) != std::string_view::npos) {
      ++at;
      continue;
    }
    char* end = nullptr;
    const double x = std::strtod(at, &end);
    if (end == at || *end != ',') throw std::runtime_error("unknown path data: " + data);
    at = end + 1;
    const double y = std::strtod(at, &end);
    if (end == at) throw std::runtime_error("unknown path data: " + data);
    at = end;
    if (outlines.empty()) outlines.emplace_back();
    outlines.back().corners.push_back({x, y});
  }
  return outlines;
}

/// A mark around the origin, as gnuplot defines it.
struct Symbol {
  std::vector<Outline> outlines;
  bool filled = false;
  double width = 0;  ///< of its line
};

class Reader {
 public:
  explicit Reader(const pugi::xml_document& document) : document_(document) {}

  Picture read() {
    const pugi::xml_node root = document_.child("svg");
    picture_.width = root.attribute("width").as_int();
    picture_.height = root.attribute("height").as_int();
    picture_.layers.emplace_back();
    for (const pugi::xpath_node& found : document_.select_nodes("//pattern")) {
      const std::string id = found.node().attribute("id").value();
      picture_.patterns["url(#" + id + ")"] = found.node();
    }
    for (const pugi::xml_node child : root.children()) read(child, {});
    if (!bar_.empty()) picture_.bar = bar_of();
    return std::move(picture_);
  }

 private:
  /// What the groups around say.
  struct Around {
    std::string stroke, width, color, turned;
    bool crisp = false, plot = false;
    pugi::xml_node text_style;
  };

  void read(pugi::xml_node node, Around around) {
    const std::string name = node.name();
    if (name == "title" || name == "desc" || name == "defs" || name.empty()) return;
    if (name == "g") {
      read_group(node, around);
    } else if (name == "path") {
      add(brush_of(node, around), lines_of(node.attribute("d").value()));
    } else if (name == "polygon") {
      read_area(node, around);
    } else if (name == "use") {
      read_mark(node);
    } else if (name == "text") {
      read_text(node, around);
    } else if (name != "rect" || std::string_view(node.attribute("x").value()) != "0") {
      throw std::runtime_error(fmt::format("gnuplot draws an unknown <{}>", name));
    }
  }

  void read_group(pugi::xml_node group, Around around) {
    const bool plot = std::string_view(group.attribute("id").value()).starts_with("gnuplot_plot");
    if (const auto stroke = group.attribute("stroke")) around.stroke = stroke.value();
    if (const auto width = group.attribute("stroke-width")) around.width = width.value();
    if (const auto color = group.attribute("color")) around.color = color.value();
    if (group.attribute("shape-rendering")) around.crisp = true;
    if (group.attribute("transform")) around.text_style = group;
    if (plot) {
      around.plot = true;
      picture_.layers.emplace_back();
    }
    in_frame_ = !around.plot;
    for (const pugi::xml_node child : group.children()) read(child, around);
    if (plot) in_frame_ = true;
  }

  static std::vector<Outline> lines_of(const std::string& data) {
    std::vector<Outline> lines = outlines_of(data);
    std::erase_if(lines, [](const Outline& line) { return line.corners.size() < 2; });
    return lines;
  }

  static Brush brush_of(pugi::xml_node node, const Around& around) {
    std::string stroke = node.attribute("stroke").as_string(around.stroke.c_str());
    if (stroke == "currentColor") stroke = around.color;
    const std::string width = short_number(around.width);
    return {.stroke = colour_of(stroke),
            .width = width == "1" ? "" : width,
            .dash = node.attribute("stroke-dasharray").value()};
  }

  void read_area(pugi::xml_node node, const Around& around) {
    std::vector<Outline> areas = outlines_of(node.attribute("points").value());
    for (Outline& area : areas) area.closed = true;
    Brush brush{.fill = colour_of(node.attribute("fill").value()),
                .opacity = short_number(node.attribute("fill-opacity").value()),
                .crisp = around.crisp && node.attribute("fill-opacity").empty()};
    if (in_frame_) {
      for (const Outline& area : areas) bar_.emplace_back(area, brush.fill);
    } else {
      add(std::move(brush), std::move(areas));
    }
  }

  void read_text(pugi::xml_node node, const Around& around) {
    const std::string text = node.child_value();
    if (text.find_first_not_of(' ') == std::string::npos) return;
    const pugi::xml_node style = around.text_style;
    const std::string transform = style.attribute("transform").value();
    Writing writing{.fill = colour_of(style.attribute("fill").value()),
                    .size = short_number(style.attribute("font-size").value()),
                    .anchor = style.attribute("text-anchor").value(),
                    .weight = style.attribute("font-family").value(),
                    .place = {},
                    .text = text};
    double turned = 0;
    const int numbers = std::sscanf(transform.c_str(), "translate(%lf,%lf) rotate(%lf)",
                                    &writing.place.x, &writing.place.y, &turned);
    if (numbers < 2) throw std::runtime_error("gnuplot places a text unknowably: " + transform);
    if (numbers == 3) writing.turned = fmt::format("rotate({:g})", turned);
    picture_.writings.push_back(std::move(writing));
  }

  /// The mark of that id, from those that gnuplot defines: shapes, and uses of other marks.
  Symbol mark_of(const std::string& id) const {
    const pugi::xml_node node =
        document_.select_node(fmt::format("//defs/*[@id = '{}']", id).c_str()).node();
    const std::string name = node.name();
    const auto number = [&](const char* key) { return node.attribute(key).as_double(); };
    if (name == "use") {
      Symbol mark = mark_of(node.attribute("xlink:href").value() + 1);
      double turned = 0;
      std::sscanf(node.attribute("transform").value(), "rotate(%lf)", &turned);
      turn(mark.outlines, turned);
      if (node.attribute("fill")) mark.filled = true;
      return mark;
    }
    const double width = number("stroke-width");
    const bool filled = !node.attribute("fill").empty();
    if (name == "circle") return {{{{{0, 0}}, true, number("r")}}, filled, width};
    if (name == "path") return {outlines_of(node.attribute("d").value()), filled, width};
    if (name != "rect") throw std::runtime_error("gnuplot defines an unknown mark " + id);
    const double x = number("x"), y = number("y"), w = number("width"), h = number("height");
    return {{{{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, true}}, filled, width};
  }

  static void turn(std::vector<Outline>& outlines, double degrees) {
    const double sine = std::sin(degrees * M_PI / 180), cosine = std::cos(degrees * M_PI / 180);
    for (Outline& outline : outlines) {
      for (Pixel& corner : outline.corners) {
        corner = {cosine * corner.x - sine * corner.y, sine * corner.x + cosine * corner.y};
      }
    }
  }

  void read_mark(pugi::xml_node node) {
    const std::string id = node.attribute("xlink:href").value() + 1;
    const auto found = marks_.find(id);
    const Symbol& mark = found != marks_.end() ? found->second : marks_[id] = mark_of(id);
    double x = 0, y = 0, scale = 0;
    if (std::sscanf(node.attribute("transform").value(), "translate(%lf,%lf) scale(%lf)", &x, &y,
                    &scale) != 3) {
      throw std::runtime_error("gnuplot places a mark unknowably");
    }
    const std::string colour = colour_of(node.attribute("color").value());
    const std::string width = fmt::format("{:.2g}", mark.width * scale);
    std::vector<Outline> outlines = mark.outlines;
    for (Outline& outline : outlines) {
      for (Pixel& corner : outline.corners) corner = {x + scale * corner.x, y + scale * corner.y};
      outline.radius *= scale;
    }
    if (!mark.filled) return add({.stroke = colour, .width = width}, std::move(outlines));
    if (outlines.front().radius == 0) return add({.fill = colour}, std::move(outlines));
    // A dot of a broad round pen is the shortest circle.
    const std::string across = fmt::format("{:.3g}", 2 * outlines.front().radius);
    add({.stroke = colour, .width = across, .cap = "round"}, {{outlines.front().corners}});
  }

  /// Outlines of one brush in one layer come together.
  void add(Brush brush, std::vector<Outline> outlines) {
    if (outlines.empty()) return;
    Layer& layer = in_frame_ ? picture_.layers.front() : picture_.layers.back();
    auto found =
        std::ranges::find_if(layer, [&](const auto& entry) { return entry.first == brush; });
    if (found == layer.end()) found = layer.insert(layer.end(), {std::move(brush), {}});
    std::vector<Outline>& all = found->second;
    for (Outline& outline : outlines) {
      // gnuplot draws the border of the plot twice.
      if (in_frame_ && std::ranges::find(all, outline) != all.end()) continue;
      all.push_back(std::move(outline));
    }
  }

  /// gnuplot paints the bar as many thin areas.
  ColourBar bar_of() {
    const auto height = [](const auto& part) { return part.first.corners.front().y; };
    std::ranges::stable_sort(bar_, std::greater<>(), height);
    Pixel least = bar_.front().first.corners.front(), most = least;
    for (const auto& [area, colour] : bar_) {
      for (const Pixel& corner : area.corners) {
        least = {std::min(least.x, corner.x), std::min(least.y, corner.y)};
        most = {std::max(most.x, corner.x), std::max(most.y, corner.y)};
      }
    }
    ColourBar bar{{{{least.x, most.y}, most, {most.x, least.y}, least}, true}, {}};
    for (std::size_t i = 0; i <= palette_steps; ++i) {
      bar.colours.push_back(bar_[i * (bar_.size() - 1) / palette_steps].second);
    }
    return bar;
  }

  const pugi::xml_document& document_;
  Picture picture_;
  std::map<std::string, Symbol> marks_;
  std::vector<std::pair<Outline, std::string>> bar_;
  bool in_frame_ = true;
};

}  // namespace

Picture picture_of(const pugi::xml_document& document) {
  return Reader(document).read();
}

}  // namespace ricochet::report
