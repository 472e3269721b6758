#include "src/report/short_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <tuple>

#include "src/report/path_data.h"
#include "src/report/script.h"

namespace ricochet::report {
namespace {

constexpr const char* usual_size = "12";

void say(pugi::xml_node element, const char* name, const std::string& value) {
  if (!value.empty()) element.append_attribute(name) = value.c_str();
}

class Writer {
 public:
  Writer(const Picture& picture, const std::string& name) : picture_(picture), name_(name) {
    root_ = document_.append_child("svg");
  }

  std::string write(const std::string& title, const std::string& description) {
    begin(title, description);
    if (picture_.bar) write_bar(*picture_.bar);
    write_patterns();
    pugi::xml_node drawn = root_.append_child("g");
    drawn.append_attribute("fill") = "none";
    for (const Layer& layer : picture_.layers) write_layer(drawn, layer);
    write_texts();
    std::ostringstream stream;
    document_.save(stream, "", pugi::format_indent | pugi::format_no_declaration);
    return stream.str();
  }

 private:
  void begin(const std::string& title, const std::string& description) {
    const std::string width = std::to_string(picture_.width);
    const std::string height = std::to_string(picture_.height);
    say(root_, "class", "ricochet-chart");
    say(root_, "width", width);
    say(root_, "height", height);
    say(root_, "viewBox", fmt::format("0 0 {} {}", width, height));
    say(root_, "xmlns", "http://www.w3.org/2000/svg");
    say(root_, "role", "img");
    say(root_, "aria-labelledby", fmt::format("{0}-title {0}-desc", name_));
    say(root_, "font-family", "system-ui, sans-serif");
    say(root_, "font-size", usual_size);
    for (const auto& [element, text] : {std::pair{"title", title}, {"desc", description}}) {
      pugi::xml_node told = root_.append_child(element);
      say(told, "id", fmt::format("{}-{}", name_, element));
      told.text() = text.c_str();
    }
    pugi::xml_node paper = root_.append_child("rect");
    say(paper, "width", width);
    say(paper, "height", height);
    say(paper, "fill", "#ffffff");
  }

  void write_bar(const ColourBar& bar) {
    const std::string id = name_ + "-bar";
    pugi::xml_node gradient = root_.append_child("linearGradient");
    say(gradient, "id", id);
    for (const char* across : {"x1", "x2", "y2"}) say(gradient, across, "0");
    say(gradient, "y1", "1");
    for (std::size_t i = 0; i < bar.colours.size(); ++i) {
      pugi::xml_node stop = gradient.append_child("stop");
      say(stop, "offset",
          fmt::format("{:.3g}",
                      static_cast<double>(i) / static_cast<double>(bar.colours.size() - 1)));
      say(stop, "stop-color", bar.colours[i]);
    }
    pugi::xml_node box = root_.append_child("path");
    say(box, "fill", "url(#" + id + ")");
    say(box, "d", path_data({bar.box}));
  }

  /// Those with the same content are one.
  void write_patterns() {
    for (const auto& [use, pattern] : picture_.patterns) {
      std::ostringstream content;
      for (const pugi::xml_node child : pattern.children())
        child.print(content, "", pugi::format_raw);
      auto [known, is_new] = pattern_of_content_.try_emplace(
          content.str(), fmt::format("{}-{}", name_, pattern.attribute("id").value()));
      pattern_of_use_[use] = "url(#" + known->second + ")";
      if (!is_new) continue;
      root_.append_copy(pattern).attribute("id") = known->second.c_str();
    }
  }

  void write_layer(pugi::xml_node drawn, const Layer& layer) {
    pugi::xml_node crisp;
    for (const auto& [brush, outlines] : layer) {
      if (brush.crisp && !crisp) {
        crisp = drawn.append_child("g");
        say(crisp, "shape-rendering", "crispEdges");
      }
      write_path(brush.crisp ? crisp : drawn, brush, outlines);
    }
  }

  void write_path(pugi::xml_node drawn, const Brush& brush, const std::vector<Outline>& outlines) {
    const std::string data = path_data(brush.fill.empty() ? outlines : joined_rectangles(outlines));
    if (data.empty()) return;
    pugi::xml_node path = drawn.append_child("path");
    const auto pattern = pattern_of_use_.find(brush.fill);
    say(path, "fill", pattern == pattern_of_use_.end() ? brush.fill : pattern->second);
    say(path, "fill-opacity", brush.opacity);
    say(path, "stroke", brush.stroke);
    say(path, "stroke-width", brush.width);
    say(path, "stroke-dasharray", brush.dash);
    say(path, "stroke-linecap", brush.cap);
    say(path, "d", data);
  }

  void write_texts() {
    std::vector<std::vector<const Writing*>> groups;
    for (const Writing& writing : picture_.writings) {
      const auto alike = [&](const auto& group) {
        return group.front()->style() == writing.style();
      };
      auto found = std::ranges::find_if(groups, alike);
      if (found == groups.end()) found = groups.insert(groups.end(), {{}});
      found->push_back(&writing);
    }
    for (const auto& group : groups) {
      const bool alone = group.size() == 1;
      pugi::xml_node around = alone ? root_ : root_.append_child("g");
      if (!alone) say_style(around, *group.front());
      for (const Writing* writing : group) {
        pugi::xml_node text = around.append_child("text");
        if (alone) say_style(text, *writing);
        write_place(text, *writing);
        text.text() = writing->text.c_str();
      }
    }
  }

  static void say_style(pugi::xml_node element, const Writing& writing) {
    say(element, "fill", writing.fill);
    if (writing.size != usual_size) say(element, "font-size", writing.size);
    if (writing.anchor != "start") say(element, "text-anchor", writing.anchor);
    if (writing.weight == title_font) say(element, "font-weight", "600");
  }

  static void write_place(pugi::xml_node text, const Writing& writing) {
    const std::string x = fmt::format("{:.0f}", writing.place.x);
    const std::string y = fmt::format("{:.0f}", writing.place.y);
    if (writing.turned.empty()) {
      say(text, "x", x);
      say(text, "y", y);
    } else {
      say(text, "transform", fmt::format("translate({},{}){}", x, y, writing.turned));
    }
  }

  const Picture& picture_;
  const std::string& name_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::map<std::string, std::string> pattern_of_content_, pattern_of_use_;
};

}  // namespace

std::string short_svg(const Picture& picture, const std::string& name, const std::string& title,
                      const std::string& description) {
  return Writer(picture, name).write(title, description);
}

}  // namespace ricochet::report
