#include "src/report/short_svg.h"

#include <fmt/format.h>

#include <cstdio>
#include <regex>
#include <string>
#include <string_view>
#include <utility>

namespace ricochet::report {
namespace {

/// What gnuplot says of every group, though it is what SVG has anyway.
constexpr std::pair<const char*, std::string_view> needless[] = {
    {"stroke-width", "1.00"}, {"stroke-linecap", "butt"}, {"stroke-linejoin", "miter"}};

/// What it says of every group, which the one around all may say for them.
constexpr std::pair<const char*, std::string_view> common[] = {
    {"fill", "none"}, {"color", "black"}, {"stroke", "currentColor"}};

void remove_where(pugi::xml_node element, const char* name, std::string_view value) {
  const pugi::xml_attribute attribute = element.attribute(name);
  if (attribute.value() == value) element.remove_attribute(attribute);
}

void say_once(pugi::xml_document& document) {
  pugi::xml_node all = document.select_node("//g[@id = 'gnuplot_canvas']").node();
  for (const pugi::xpath_node& found : document.select_nodes("//g[@stroke = 'currentColor']")) {
    for (const auto& [name, value] : needless) remove_where(found.node(), name, value);
    for (const auto& [name, value] : common) remove_where(found.node(), name, value);
  }
  if (!all) return;
  for (const auto& [name, value] : common) {
    all.append_attribute(name) = std::string(value).c_str();
  }
  if (pugi::xml_node paper = all.child("rect")) paper.append_attribute("stroke") = "none";
}

/// Puts what a group without attributes holds in its place.
void open_bare_groups(pugi::xml_document& document) {
  for (const pugi::xpath_node& found : document.select_nodes("//g[not(@*)]")) {
    pugi::xml_node group = found.node();
    while (const pugi::xml_node child = group.first_child()) {
      group.parent().insert_move_before(child, group);
    }
    group.parent().remove_child(group);
  }
}

/// Gives a text what the group around it says, where it is alone in there.
void join_groups_of_texts(pugi::xml_document& document) {
  for (const pugi::xpath_node& found :
       document.select_nodes("//g[@transform and count(*) = 1 and text[not(@*)]]")) {
    pugi::xml_node group = found.node();
    pugi::xml_node text = group.child("text");
    for (const pugi::xml_attribute attribute : group.attributes()) {
      text.append_copy(attribute);
    }
    group.parent().insert_move_before(text, group);
    group.parent().remove_child(group);
  }
}

void shorten_colour(pugi::xml_attribute colour) {
  unsigned red = 0, green = 0, blue = 0;
  if (std::sscanf(colour.value(), "rgb(%u,%u,%u)", &red, &green, &blue) != 3) return;
  colour = fmt::format("#{:02x}{:02x}{:02x}", red, green, blue).c_str();
}

/// Cuts coordinates after their first decimal, which is less than a pixel of any screen.
void shorten_numbers(pugi::xml_attribute attribute) {
  static const std::regex decimals(R"((\.\d)\d+)");
  static const std::regex zero(R"(\.0\b)");
  static const std::regex spaces(R"(\s*([LM])\s*|\s+$)");
  std::string text = std::regex_replace(attribute.value(), decimals, "$1");
  text = std::regex_replace(text, zero, "");
  attribute = std::regex_replace(text, spaces, "$1").c_str();
}

}  // namespace

void shorten(pugi::xml_document& document) {
  say_once(document);
  open_bare_groups(document);
  join_groups_of_texts(document);
  for (const pugi::xpath_node& found : document.select_nodes("//@fill | //@stroke | //@color")) {
    shorten_colour(found.attribute());
  }
  // Marks are drawn larger than they are defined, and keep their digits.
  for (const pugi::xpath_node& found : document.select_nodes(
           "//@transform | //@font-size | //@stroke-width[not(ancestor::defs)] | "
           "//path[not(ancestor::defs)]/@d | //polygon[not(ancestor::defs)]/@points")) {
    shorten_numbers(found.attribute());
  }
}

}  // namespace ricochet::report
