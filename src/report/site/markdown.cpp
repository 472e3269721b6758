#include "src/report/site/markdown.h"

#include <md4c-html.h>

#include <cctype>
#include <map>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

namespace ricochet::site {

namespace {

std::string html_of(const std::string& markdown) {
  std::string html = "<main>";
  const auto append = [](const MD_CHAR* text, MD_SIZE size, void* to) {
    static_cast<std::string*>(to)->append(text, size);
  };
  if (md_html(markdown.data(), static_cast<MD_SIZE>(markdown.size()), append, &html,
              MD_DIALECT_GITHUB, MD_HTML_FLAG_XHTML) != 0) {
    throw std::runtime_error("a document is no Markdown");
  }
  return html + "</main>";
}

bool is_heading(const pugi::xml_node& node) {
  const std::string name = node.name();
  return name.size() == 2 && name[0] == 'h' && name[1] >= '1' && name[1] <= '6';
}

/// What is taken of a table: all, or the names of its rows.
enum class Tables { whole, names };

std::string text_of(const pugi::xml_node& node, Tables tables = Tables::whole) {
  std::string text;
  for (const pugi::xml_node& child : node.children()) {
    if (tables == Tables::names && std::string(child.name()) == "tr") {
      const auto is_cell = [](const pugi::xml_node& one) {
        return one.type() == pugi::node_element;
      };
      text += text_of(child.find_child(is_cell)) + " ";
    } else {
      text += child.type() == pugi::node_pcdata ? child.value() : text_of(child, tables);
    }
  }
  return text;
}

/// As code hosts make it: small letters, digits and hyphens.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || byte >= 0x80) anchor += static_cast<char>(std::tolower(byte));
    if (c == ' ' || c == '-') anchor += '-';
    if (c == '_') anchor += '_';
  }
  return anchor;
}

/// What has been passed of a document.
struct Passed {
  std::string heading;
  int tables = 0;
};

/// A table or a listing that is too wide can be scrolled, with the keyboard, too.
void make_scrollable(pugi::xml_node node, Passed& passed) {
  if (std::string(node.name()) == "pre") {
    node.append_attribute("tabindex") = "0";
    return;
  }
  const std::string label =
      "table " + std::to_string(++passed.tables) + ": " + passed.heading;  // unique on the page
  pugi::xml_node frame = node.parent().insert_child_before("div", node);
  frame.append_attribute("class") = "scroll";
  frame.append_attribute("role") = "region";
  frame.append_attribute("aria-label") = label.c_str();
  frame.append_attribute("tabindex") = "0";
  frame.append_move(node);
}

/// Alignment is a class on this site.
void align(pugi::xml_node cell) {
  const bool right = std::string(cell.attribute("align").value()) == "right";
  cell.remove_attribute("align");
  cell.append_attribute("class") = right ? "right" : "left";
  if (text_of(cell).empty()) cell.set_name("td");  // an empty cell heads nothing
}

void lead(pugi::xml_node link, const LinkTarget& target) {
  const std::string to = target(link.attribute("href").value());
  link.remove_attributes();
  link.set_name(to.empty() ? "span" : "a");
  if (!to.empty()) link.append_attribute("href") = to.c_str();
}

/// A picture that the site does not have is its text.
void show(pugi::xml_node picture, const LinkTarget& target) {
  const std::string from = target(picture.attribute("src").value());
  picture.attribute("src") = from.c_str();
  if (!from.empty()) return;
  picture.set_name("span");
  picture.append_child(pugi::node_pcdata).set_value(picture.attribute("alt").value());
  picture.remove_attributes();
}

/// Changes all below a node, whose children may move.
void refine(pugi::xml_node node, const LinkTarget& target, Passed& passed) {
  std::vector<pugi::xml_node> children;
  for (const pugi::xml_node& child : node.children()) children.push_back(child);
  for (pugi::xml_node child : children) {
    const std::string name = child.name();
    if (is_heading(child)) {
      passed.heading = text_of(child);
      child.append_attribute("id") = anchor_of(passed.heading).c_str();
    }
    refine(child, target, passed);
    if (name == "a") lead(child, target);
    if (name == "img") show(child, target);
    if (name == "th" || name == "td") align(child);
    if (name == "table" || name == "pre") make_scrollable(child, passed);
  }
}

std::vector<DocumentPart> parts_of(const pugi::xml_node& main) {
  std::vector<DocumentPart> parts;
  for (const pugi::xml_node& node : main.children()) {
    if (is_heading(node)) {
      parts.push_back({text_of(node), node.attribute("id").value(), "", ""});
    } else if (!parts.empty()) {
      parts.back().text += text_of(node) + " ";
      parts.back().prose += text_of(node, Tables::names) + " ";
    }
  }
  return parts;
}

}  // namespace

Document document_of(const std::string& markdown, const LinkTarget& target) {
  pugi::xml_document tree;
  const std::string html = html_of(markdown);
  const pugi::xml_parse_result parsed =
      tree.load_buffer(html.data(), html.size(), pugi::parse_default | pugi::parse_ws_pcdata);
  if (!parsed) throw std::runtime_error(std::string("a document: ") + parsed.description());
  const pugi::xml_node main = tree.child("main");
  Passed passed;
  refine(main, target, passed);
  Document document;
  document.parts = parts_of(main);
  if (!document.parts.empty()) document.title = document.parts.front().heading;
  std::ostringstream stream;
  for (const pugi::xml_node& node : main.children()) {
    node.print(stream, "", pugi::format_raw | pugi::format_no_empty_element_tags);
  }
  document.html = stream.str();
  return document;
}

}  // namespace ricochet::site
