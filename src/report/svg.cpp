#include "src/report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

#include "src/report/picture.h"
#include "src/report/short_svg.h"

namespace ricochet::report {
namespace {

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
  try {
    return short_svg(picture_of(document), name, title, description);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("chart {}: {}", name, error.what()));
  }
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
