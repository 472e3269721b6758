#include "src/report/drawing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <new>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "src/report/chart.h"
#include "src/report/frame.h"
#include "src/report/json.h"
#include "src/report/svg.h"
#include "src/report/text.h"

namespace ricochet::report {

namespace {

constexpr int usual_size = 12;

void say(pugi::xml_node element, const char* name, const std::string& value) {
  if (!value.empty()) element.append_attribute(name) = value.c_str();
}

/// Removes what XML cannot hold: invalid UTF-8 and control characters.
std::string fit_for_xml(const std::string& text) {
  const std::string dumped = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  auto fit = Json::parse(dumped).get<std::string>();
  for (char& c : fit)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return fit;
}

pugi::xml_node add_text(pugi::xml_node parent, const char* element, const std::string& text) {
  pugi::xml_node added = parent.append_child(element);
  added.text() = fit_for_xml(text).c_str();
  return added;
}

void say_size(pugi::xml_node picture, int width, int height) {
  picture.append_attribute("class") = "ricochet-chart";
  picture.append_attribute("width") = width;
  picture.append_attribute("height") = height;
  say(picture, "viewBox", fmt::format("0 0 {} {}", width, height));
  say(picture, "xmlns", "http://www.w3.org/2000/svg");
}

std::string text_of(const pugi::xml_document& document) {
  std::ostringstream stream;
  document.save(stream, "", pugi::format_indent | pugi::format_no_declaration);
  std::string text = stream.str();
  // One character less for each element; texts and attributes hold no bare ">".
  for (std::size_t at = 0; (at = text.find(" />", at)) != std::string::npos;) text.erase(at, 1);
  return text;
}

}  // namespace

Drawing::Drawing(std::string name, const std::string& title, const std::string& description,
                 int width, int height)
    : name_(std::move(name)) {
  root_ = document_.append_child("svg");
  say_size(root_, width, height);
  say(root_, "role", "img");
  say(root_, "aria-labelledby", fmt::format("{0}-title {0}-desc", name_));
  say(root_, "font-family", "system-ui, sans-serif");
  say(root_, "font-size", std::to_string(usual_size));
  for (const auto& [element, text] : {std::pair{"title", title}, {"desc", description}}) {
    pugi::xml_node told = add_text(root_, element, text);
    say(told, "id", fmt::format("{}-{}", name_, element));
  }
  pugi::xml_node paper = root_.append_child("rect");
  paper.append_attribute("width") = width;
  paper.append_attribute("height") = height;
  say(paper, "fill", "#ffffff");
  paths_ = root_.append_child("g");
  say(paths_, "fill", "none");
}

void Drawing::paint(const Brush& brush, const std::vector<Outline>& outlines) {
  const std::string data = path_data(outlines);
  if (data.empty()) return;
  if (brush.crisp && !crisp_) {
    crisp_ = paths_.append_child("g");
    say(crisp_, "shape-rendering", "crispEdges");
  }
  pugi::xml_node path = (brush.crisp ? crisp_ : paths_).append_child("path");
  say(path, "fill", brush.fill);
  say(path, "fill-opacity", brush.opacity);
  say(path, "stroke", brush.stroke);
  say(path, "stroke-width", brush.width);
  say(path, "stroke-dasharray", brush.dash);
  say(path, "stroke-linecap", brush.cap);
  say(path, "clip-path", brush.clip);
  say(path, "d", data);
}

void Drawing::write(const Lettering& lettering, const std::vector<Writing>& writings) {
  if (writings.empty()) return;
  pugi::xml_node group = root_.append_child("g");
  say(group, "fill", lettering.colour);
  if (lettering.anchor != "start") say(group, "text-anchor", lettering.anchor);
  if (lettering.size != usual_size) group.append_attribute("font-size") = lettering.size;
  if (lettering.bold) say(group, "font-weight", "600");
  for (const Writing& writing : writings) {
    pugi::xml_node text = add_text(group, "text", writing.text);
    const std::string x = fmt::format("{:.0f}", writing.place.x);
    const std::string y = fmt::format("{:.0f}", writing.place.y);
    if (lettering.turned == 0) {
      say(text, "x", x);
      say(text, "y", y);
    } else {
      say(text, "transform", fmt::format("translate({},{})rotate({:g})", x, y, lettering.turned));
    }
  }
}

std::string Drawing::gradient(const std::vector<std::string>& colours) {
  const std::string id = name_ + "-bar";
  pugi::xml_node gradient = root_.insert_child_before("linearGradient", paths_);
  say(gradient, "id", id);
  for (const char* across : {"x1", "x2", "y2"}) say(gradient, across, "0");
  say(gradient, "y1", "1");
  for (std::size_t i = 0; i < colours.size(); ++i) {
    pugi::xml_node stop = gradient.append_child("stop");
    const double place = static_cast<double>(i) / static_cast<double>(colours.size() - 1);
    say(stop, "offset", fmt::format("{:.3g}", place));
    say(stop, "stop-color", colours[i]);
  }
  return "url(#" + id + ")";
}

std::string Drawing::hatching() {
  const std::string id = name_ + "-hatching";
  std::string fill = "url(#" + id + ")";
  if (root_.child("pattern")) return fill;
  pugi::xml_node pattern = root_.insert_child_before("pattern", paths_);
  say(pattern, "id", id);
  say(pattern, "patternUnits", "userSpaceOnUse");
  for (const char* side : {"width", "height"}) say(pattern, side, "8");
  pugi::xml_node lines = pattern.append_child("path");
  say(lines, "stroke", "#9a9a9a");
  say(lines, "d", "M-4 0l12 12m-8-16l12 12");
  return fill;
}

std::string Drawing::clip(const Box& box) {
  constexpr double edge = 2;  // pixels
  const std::string id = name_ + "-plot";
  pugi::xml_node path = root_.insert_child_before("clipPath", paths_);
  say(path, "id", id);
  pugi::xml_node inside = path.append_child("rect");
  say(inside, "x", fmt::format("{:.0f}", box.left - edge));
  say(inside, "y", fmt::format("{:.0f}", box.top - edge));
  say(inside, "width", fmt::format("{:.0f}", box.width() + 2 * edge));
  say(inside, "height", fmt::format("{:.0f}", box.height() + 2 * edge));
  return "url(#" + id + ")";
}

std::string Drawing::text() const {
  return text_of(document_);
}

std::string stacked(const std::vector<std::string>& svgs) {
  if (svgs.size() == 1) return svgs.front();
  pugi::xml_document document;
  pugi::xml_node all = document.append_child("svg");
  int width = 0, height = 0;
  for (const std::string& svg : svgs) {
    pugi::xml_document part;
    part.load_string(svg.c_str());
    pugi::xml_node placed = all.append_copy(part.child("svg"));
    placed.append_attribute("y") = height;
    width = std::max(width, placed.attribute("width").as_int());
    height += placed.attribute("height").as_int();
  }
  say_size(all, width, height);
  say(all, "role", "group");
  return text_of(document);
}

namespace {

std::string words_for(const DrawnChart& chart) {
  return fmt::format("This chart could not be drawn: {}: {}",
                     chart.title.empty() ? chart.name : chart.title, chart.failure);
}

}  // namespace

DrawnChart draw(const Chart& chart) {
  try {
    return {chart.name, chart.title, to_svg(chart)};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return {chart.name, chart.title, "", error.what()};
  }
}

namespace {

std::string in_page_of(const std::string& place) {
  const std::size_t hash = place.find('#');
  if (hash == std::string::npos) throw std::invalid_argument("a cell's link has no #: " + place);
  return place.substr(0, hash) + "/index.html" + place.substr(hash);
}

}  // namespace

Json cell_links_data(const Chart& chart) {
  const HeatMap& map = chart.heat_map.value();
  if (map.row_links.size() != chart.y.categories.size() ||
      map.column_links.size() != chart.x.categories.size()) {
    throw std::invalid_argument("chart \"" + chart.name + "\": not a link for each row and column");
  }
  const Box box = frame_of(chart).plot;
  Json rows = Json::array(), columns = Json::array();
  for (std::size_t row = map.row_links.size(); row-- > 0;) {
    rows.push_back({chart.y.categories[row], in_page_of(map.row_links[row])});
  }
  for (std::size_t column = 0; column < map.column_links.size(); ++column) {
    columns.push_back({chart.x.categories[column], map.column_links[column]});
  }
  return {{"box", {box.left, box.right, box.top, box.bottom}},
          {"rows", std::move(rows)},
          {"columns", std::move(columns)}};
}

std::string html_of(const Chart& chart, const DrawnChart& drawn) {
  if (!drawn.is_drawn()) {
    return fmt::format("<p class=\"bad\">{}</p>", escape_html(words_for(drawn)));
  }
  std::string html = drawn.svg + data_script("chart-csv", csv_of(chart));
  if (has_cell_links(chart)) html += data_script("chart-links", cell_links_data(chart));
  return html;
}

std::string markdown_of(const DrawnChart& chart) {
  if (!chart.is_drawn()) return fmt::format("**{}**", escape_markdown(words_for(chart)));
  return fmt::format("![{}]({}.svg)", escape_markdown(chart.title), chart.name);
}

std::string failure_of(const DrawnChart& chart) {
  return fmt::format("chart {} could not be drawn: {}", chart.name, chart.failure);
}

Plot plot_of(const std::vector<Chart>& charts) {
  Plot plot;
  std::vector<std::string> svgs;
  for (const Chart& chart : charts) {
    const DrawnChart drawn = draw(chart);
    (drawn.is_drawn() ? svgs : plot.failures)
        .push_back(drawn.is_drawn() ? drawn.svg : failure_of(drawn));
  }
  if (!svgs.empty()) plot.svg = stacked(svgs);
  return plot;
}

void require_none(const std::vector<std::string>& failures) {
  if (!failures.empty()) throw std::runtime_error(fmt::format("{}", fmt::join(failures, "; ")));
}

std::string json_in_script(const std::string& json) {
  std::string text = json;
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
    text.replace(at, 1, "\\u003c");
  return text;
}

std::string data_script(const char* name, const Json& data) {
  return fmt::format("<script type=\"application/json\" class=\"{}\">{}</script>", name,
                     json_in_script(data.dump()));
}

}  // namespace ricochet::report
