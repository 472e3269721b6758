#include "src/report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "src/report/script.h"
#include "src/report/short_svg.h"

namespace ricochet::report {
namespace {

/// Removes filters, the titles that gnuplot gives every plot, groups without content and markers
/// without use, until there are none: each may have been all that held or used another.
void drop_ballast(pugi::xml_document& document) {
  const pugi::xpath_query ballast(
      "//filter | //g/title | //g[not(*)] | "
      "//defs/*[starts-with(@id, 'gp') and not(*) and not(concat('#', @id) = //@xlink:href)]");
  for (auto found = ballast.evaluate_node_set(document); !found.empty();
       found = ballast.evaluate_node_set(document))
    for (const pugi::xpath_node& node : found) node.parent().remove_child(node.node());
}

/// Puts the name before what the attribute says of an id, if it does.
void name_id(pugi::xml_attribute attribute, const std::string& name) {
  static constexpr std::string_view fragment = "#", paint = "url(#";
  const std::string_view what = attribute.name();
  std::string value = attribute.value();
  if (what == "id")
    value.insert(0, name + "-");
  else if (what == "xlink:href")
    value.insert(fragment.size(), name + "-");
  else if (value.starts_with(paint))
    value.insert(paint.size(), name + "-");
  attribute = value.c_str();
}

/// Only the weight of a font is not the reader's own.
void drop_font(pugi::xml_node element) {
  pugi::xml_attribute font = element.attribute("font-family");
  if (font.value() == std::string_view(title_font)) element.append_attribute("font-weight") = "600";
  element.remove_attribute(font);
}

std::string text_of(const pugi::xml_document& document) {
  std::ostringstream stream;
  document.save(stream, "", pugi::format_default | pugi::format_no_declaration);
  return stream.str();
}

}  // namespace

std::string finish_svg(const std::string& svg, const std::string& name, const std::string& title,
                       const std::string& description) {
  pugi::xml_document document;
  if (const auto parsed = document.load_string(svg.c_str()); !parsed)
    throw std::runtime_error(fmt::format("chart {}: no SVG: {}", name, parsed.description()));
  drop_ballast(document);
  shorten(document);
  for (const pugi::xpath_node& id : document.select_nodes("//@*")) name_id(id.attribute(), name);
  for (const pugi::xpath_node& text : document.select_nodes("//*[@font-family]"))
    drop_font(text.node());
  pugi::xml_node root = document.child("svg");
  for (const auto& [element, text] : {std::pair{"title", title}, {"desc", description}}) {
    root.child(element).text() = text.c_str();
    root.child(element).append_attribute("id") = fmt::format("{}-{}", name, element).c_str();
  }
  root.prepend_attribute("class") = "ricochet-chart";
  root.append_attribute("role") = "img";
  root.append_attribute("aria-labelledby") = fmt::format("{0}-title {0}-desc", name).c_str();
  root.append_attribute("font-family") =
      "system-ui, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";
  return text_of(document);
}

std::string stacked(const std::vector<std::string>& svgs) {
  if (svgs.size() == 1) return svgs.front();
  pugi::xml_document document;
  pugi::xml_node all = document.append_child("svg");
  int width = 0, height = 0;
  for (const std::string& svg : svgs) {
    pugi::xml_document part;
    if (const auto parsed = part.load_string(svg.c_str()); !parsed)
      throw std::runtime_error(fmt::format("no SVG: {}", parsed.description()));
    pugi::xml_node placed = all.append_copy(part.child("svg"));
    placed.append_attribute("y") = height;
    width = std::max(width, placed.attribute("width").as_int());
    height += placed.attribute("height").as_int();
  }
  all.append_attribute("class") = "ricochet-chart";
  all.append_attribute("width") = width;
  all.append_attribute("height") = height;
  all.append_attribute("viewBox") = fmt::format("0 0 {} {}", width, height).c_str();
  all.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
  all.append_attribute("role") = "group";
  return text_of(document);
}

}  // namespace ricochet::report
