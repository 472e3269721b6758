#include "src/report/markdown_html.h"

#include <fmt/format.h>
#include <md4c-html.h>

#include <cctype>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "embedded/chart_data_script.h"
#include "embedded/chart_links_script.h"
#include "embedded/choose_script.h"
#include "embedded/look.h"
#include "embedded/sheet_template.h"
#include "embedded/view_form.h"
#include "embedded/view_look.h"
#include "embedded/view_scripts.h"
#include "src/report/text.h"

namespace ricochet::report {

namespace {

/// Charts from this width on have a row of their own.
constexpr int wide_chart = 560;  // pixels

/// A screen shows this many rows of a longer table until the reader asks for all.
constexpr int rows_at_first = 10;

/// A table with more columns is set closer.
constexpr std::size_t many_columns = 8;

constexpr const char* view_place = "[[view]]";

void load(pugi::xml_document& tree, const std::string& markdown) {
  std::string html = "<main>";
  const auto append = [](const MD_CHAR* text, MD_SIZE size, void* to) {
    static_cast<std::string*>(to)->append(text, size);
  };
  const bool read = md_html(markdown.data(), static_cast<MD_SIZE>(markdown.size()), append, &html,
                            MD_DIALECT_GITHUB, MD_HTML_FLAG_XHTML) == 0;
  html += "</main>";
  constexpr unsigned options = pugi::parse_default | pugi::parse_ws_pcdata | pugi::parse_comments;
  if (!read || !tree.load_buffer(html.data(), html.size(), options))
    throw std::runtime_error("a page is no Markdown");
}

/// What is taken of a table: all, or the names of its rows.
enum class Tables { whole, names };

std::string text_of(const pugi::xml_node& node, Tables tables = Tables::whole) {
  const auto is_cell = [](const pugi::xml_node& one) { return one.type() == pugi::node_element; };
  std::string text;
  for (const pugi::xml_node& child : node.children()) {
    if (tables == Tables::names && std::string_view(child.name()) == "tr") {
      text += text_of(child.find_child(is_cell)) + " ";
    } else {
      text += child.type() == pugi::node_pcdata ? child.value() : text_of(child, tables);
    }
  }
  return text;
}

bool is(const pugi::xml_node& node, std::string_view name) {
  return node.name() == name;
}

bool is_heading(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name.size() == 2 && name[0] == 'h' && name[1] >= '1' && name[1] <= '6';
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

void put_attribute(pugi::xml_node element, const char* name, const std::string& value) {
  element.append_attribute(name) = value.c_str();
}

/// What a comment says after "choose:" or "part:"; empty if it says something else.
std::string said_after(const pugi::xml_node& comment, std::string_view word) {
  const std::string_view text = comment.value();
  const std::size_t start = text.find(word);
  if (start != 1) return "";
  const std::size_t from = start + word.size();
  const std::size_t end = text.find_last_not_of(' ');
  return std::string(text.substr(from + 1, end - from));
}

/// Moves the nodes of a page into a header, sections and what a reader chooses.
class Arranger {
 public:
  Arranger(const pugi::xml_node& from, pugi::xml_node header, pugi::xml_node main)
      : main_(main), open_({header}) {
    std::vector<pugi::xml_node> nodes;
    for (const pugi::xml_node& node : from.children()) nodes.push_back(node);
    for (const pugi::xml_node& node : nodes) take(node);
  }

 private:
  void take(const pugi::xml_node& node) {
    if (node.type() == pugi::node_comment) return take_comment(node);
    if (is(node, "h2")) {
      open_ = {main_.append_child("section")};
      const std::string id = anchor_of(text_of(node));
      put_attribute(open_.back(), "id", id);
      put_attribute(open_.back(), "aria-labelledby", id + "-heading");
      put_attribute(open_.back().append_move(node), "id", id + "-heading");
      return;
    }
    const pugi::xml_node moved = open_.back().append_move(node);
    if (is_heading(moved) && !is(moved, "h1") && !in_part())
      put_attribute(moved, "id", anchor_of(text_of(moved)));
  }

  bool in_part() const {
    return std::string_view(open_.back().attribute("class").value()) == "choice";
  }

  void take_comment(const pugi::xml_node& comment) {
    if (const auto label = said_after(comment, "choose:"); !label.empty()) {
      pugi::xml_node choices = open_.back().append_child("div");
      put_attribute(choices, "class", "choices");
      put_attribute(choices, "data-label", label);
      open_.push_back(choices);
    } else if (const auto part = said_after(comment, "part:"); !part.empty()) {
      if (in_part()) open_.pop_back();
      pugi::xml_node choice = open_.back().append_child("div");
      const std::size_t blank = part.find(' ');
      put_attribute(choice, "class", "choice");
      put_attribute(choice, "id", part.substr(0, blank));
      put_attribute(choice, "data-title", part.substr(blank + 1));
      open_.push_back(choice);
    } else if (std::string_view(comment.value()) == " view ") {
      open_.back().append_child(pugi::node_pcdata).set_value(view_place);
    } else if (std::string_view(comment.value()) == " end " && open_.size() > 1) {
      if (in_part()) open_.pop_back();
      open_.pop_back();
    }
  }

  pugi::xml_node main_;
  std::vector<pugi::xml_node> open_;
};

/// The titles of a table's columns as custom properties of CSS, not escaped for HTML: --1:"solver";
/// --2:"solved [%]"; On a narrow screen reports/templates/look.css writes them before the cells.
/// Empty for a table of so few columns that it fits there as it is.
std::string column_labels(const std::vector<std::string>& titles) {
  constexpr std::size_t most_that_fit = 3;
  std::string style;
  for (std::size_t i = 0; i < titles.size() && titles.size() > most_that_fit; ++i) {
    std::string quoted;
    for (const char c : titles[i])
      quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    style += fmt::format("--{}:\"{}\";", i + 1, quoted);
  }
  return style;
}

/// Changes what is inside the sections.
class Refiner {
 public:
  Refiner(const HtmlOptions& options, std::map<std::string, std::string>& later)
      : options_(options), later_(later) {}

  void refine(pugi::xml_node node) {
    std::vector<pugi::xml_node> children;
    for (const pugi::xml_node& child : node.children()) children.push_back(child);
    for (pugi::xml_node& child : children) {
      if (is_heading(child)) heading_ = text_of(child);
      if (is(child, "p") && is_picture(child.first_child())) {
        make_figure(child);
        continue;
      }
      refine(child);
      if (is(child, "a") || is(child, "img")) lead(child);
      if (is(child, "pre")) put_attribute(child, "tabindex", "0");
      if (is(child, "table")) arrange(child);
    }
    group_figures(node);
  }

  bool has_links() const { return has_links_; }

 private:
  bool is_picture(const pugi::xml_node& node) const {
    return is(node, "img") && options_.pictures.contains(node.attribute("src").value());
  }

  /// The picture stands in the page once all else is written, since scripts are no XML.
  void make_figure(pugi::xml_node paragraph) {
    const pugi::xml_node image = paragraph.first_child();
    const auto& [chart, drawn] = options_.pictures.at(image.attribute("src").value());
    paragraph.remove_child(image);
    paragraph.set_name("figure");
    if (chart.width >= wide_chart) {
      put_attribute(paragraph, "class", "wide");
      if (!chart.title.empty()) put_attribute(paragraph, "data-title", chart.title);
    }
    put_attribute(paragraph, "style", fmt::format("max-width: {}px", chart.width * 115 / 100));
    pugi::xml_node caption = paragraph.append_child("figcaption");
    while (paragraph.first_child() != caption) caption.append_move(paragraph.first_child());
    refine(caption);
    const std::string mark = fmt::format("[[picture {}]]", later_.size());
    paragraph.prepend_child(pugi::node_pcdata).set_value(mark.c_str());
    later_[mark] = chart.name.empty() ? drawn.svg : html_of(chart, drawn);
    has_links_ = has_links_ || has_cell_links(chart);
  }

  /// Neighbouring narrow figures stand side by side.
  static void group_figures(pugi::xml_node node) {
    if (is(node, "div") && std::string_view(node.attribute("class").value()) == "figures") return;
    pugi::xml_node group;
    std::vector<pugi::xml_node> children;
    for (const pugi::xml_node& child : node.children()) children.push_back(child);
    for (pugi::xml_node& child : children) {
      const bool blank =
          child.type() == pugi::node_pcdata &&
          std::string_view(child.value()).find_first_not_of(" \n") == std::string_view::npos;
      if (blank) continue;
      if (!is(child, "figure")) {
        group = {};
        continue;
      }
      if (!group) {
        group = node.insert_child_before("div", child);
        put_attribute(group, "class", "figures");
      }
      group.append_move(child);
    }
  }

  void lead(pugi::xml_node link) const {
    const char* const attribute = is(link, "img") ? "src" : "href";
    const std::string to = options_.target(link.attribute(attribute).value());
    if (!to.empty()) {
      link.attribute(attribute) = to.c_str();
      return;
    }
    const std::string alternative = link.attribute("alt").value();
    if (!alternative.empty()) link.append_child(pugi::node_pcdata).set_value(alternative.c_str());
    link.set_name("span");
    link.remove_attributes();
  }

  /// Good and bad are said by a sign and a colour.
  static void colour(pugi::xml_node cell, std::string& classes) {
    const std::string text = text_of(cell);
    if (text.starts_with("✓")) classes += " good";
    if (text.starts_with("✗")) classes += " bad";
  }

  void arrange(pugi::xml_node table) {
    std::vector<std::string> titles;
    std::vector<pugi::xml_node> heads;
    for (const pugi::xml_node& cell : table.child("thead").child("tr").children("th"))
      heads.push_back(cell);
    for (pugi::xml_node& cell : heads) {
      titles.push_back(text_of(cell));
      align(cell, "columnheader");
      if (titles.back().empty()) {
        cell.set_name("td");  // heads nothing
      } else {
        put_attribute(cell, "scope", "col");
      }
    }
    const std::string labels = column_labels(titles);
    if (!labels.empty()) {
      put_attribute(
          table, "class",
          titles.size() > many_columns ? std::string("folding many") : std::string("folding"));
      put_attribute(table, "style", labels);
    }
    int rows = 0;
    for (const pugi::xml_node& row : table.child("tbody").children("tr")) rows += !row.empty();
    const bool folds = rows > rows_at_first + 2;
    int row_number = 0;
    for (pugi::xml_node row : table.child("tbody").children("tr")) {
      if (folds && row_number++ >= rows_at_first) put_attribute(row, "class", "later");
      bool first = true;
      std::vector<pugi::xml_node> cells;
      for (const pugi::xml_node& cell : row.children("td")) cells.push_back(cell);
      for (pugi::xml_node& cell : cells) {
        align(cell, first ? "rowheader" : "cell");
        if (first && !text_of(cell).empty()) {
          cell.set_name("th");
          put_attribute(cell, "scope", "row");
        }
        first = false;
      }
    }
    frame(table, folds, rows);
  }

  static void align(pugi::xml_node cell, const char* role) {
    std::string classes =
        std::string_view(cell.attribute("align").value()) == "right" ? "right" : "left";
    cell.remove_attribute("align");
    if (std::string_view(role) != "columnheader") colour(cell, classes);
    put_attribute(cell, "class", classes);
  }

  /// A table that is too wide can be scrolled, with the keyboard, too.
  void frame(pugi::xml_node table, bool folds, int rows) {
    pugi::xml_node frame = table.parent().insert_child_before("div", table);
    const std::string id = fmt::format("table-{}", ++tables_);
    put_attribute(frame, "class", "scroll");
    put_attribute(frame, "role", "region");
    put_attribute(frame, "aria-label", fmt::format("table {}: {}", tables_, heading_));
    put_attribute(frame, "tabindex", "0");
    if (folds) {
      pugi::xml_node box = frame.append_child("input");
      put_attribute(box, "type", "checkbox");
      put_attribute(box, "id", id);
      pugi::xml_node label = frame.append_child("label");
      put_attribute(label, "for", id);
      label.text() = fmt::format("Show all {} rows", rows).c_str();
    }
    frame.append_move(table);
  }

  const HtmlOptions& options_;
  std::map<std::string, std::string>& later_;
  std::string heading_;
  int tables_ = 0;
  bool has_links_ = false;
};

std::string inner_html(const pugi::xml_node& node) {
  std::ostringstream stream;
  for (const pugi::xml_node& child : node.children())
    child.print(stream, "", pugi::format_raw | pugi::format_no_empty_element_tags);
  return stream.str();
}

/// A heading's address: that of its section, its own, or that of the part which it names.
std::string address_of(const pugi::xml_node& heading) {
  const std::string around = heading.parent().attribute("id").value();
  const bool is_name = is(heading, "h2") || around == anchor_of(text_of(heading));
  return is_name ? around : heading.attribute("id").value();
}

/// Appends a text without the ends of its lines.
void append_words(const std::string& text, std::string& to) {
  std::istringstream words(text);
  for (std::string word; words >> word;) to += word + " ";
}

void add_parts(const pugi::xml_node& from, std::vector<PagePart>& parts) {
  for (const pugi::xml_node& node : from.children()) {
    if (node.type() != pugi::node_element) continue;  // a line's end
    if (is(node, "section") || is(node, "div")) {
      add_parts(node, parts);
    } else if (is_heading(node)) {
      parts.push_back({text_of(node), address_of(node), "", ""});
    } else if (!parts.empty()) {
      append_words(text_of(node), parts.back().text);
      append_words(text_of(node, Tables::names), parts.back().prose);
    }
  }
}

std::string contents_html(const pugi::xml_node& main) {
  std::string list;
  for (const pugi::xml_node& section : main.children("section"))
    list += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.attribute("id").value(),
                        escape_html(text_of(section.child("h2"))));
  return "<nav class=\"contents\" aria-labelledby=\"page-contents\">\n<h2 "
         "id=\"page-contents\">Contents"
         "</h2>\n<ol>\n" +
         list + "</ol>\n</nav>\n";
}

}  // namespace

std::string to_page(const std::string& link) {
  const std::size_t file = link.find("summary.md");
  if (file == std::string::npos || link.find("://") != std::string::npos) return link;
  return link.substr(0, file) + "index.html" + link.substr(file + 10);
}

HtmlPage html_page(const std::string& markdown, const HtmlOptions& options) {
  pugi::xml_document tree;
  load(tree, markdown);
  pugi::xml_node header = tree.append_child("header"), main = tree.append_child("main");
  const Arranger arranger(tree.first_child(), header, main);
  HtmlPage page{text_of(header.child("h1")), "", {}};
  add_parts(header, page.parts);
  add_parts(main, page.parts);
  std::map<std::string, std::string> later;
  Refiner refiner(options, later);
  refiner.refine(header);
  refiner.refine(main);

  std::vector<std::string> scripts;
  if (!options.view.is_null()) {
    later[view_place] =
        with_slots(embedded::view_form, {{"data", json_in_script(options.view.dump())}});
    for (const auto& [name, script] : embedded::view_scripts) scripts.emplace_back(script);
  }
  if (markdown.find("<!-- choose:") != std::string::npos)
    scripts.emplace_back(embedded::choose_script);
  if (!later.empty()) scripts.emplace_back(embedded::chart_data_script);
  if (refiner.has_links()) scripts.emplace_back(embedded::chart_links_script);
  const std::string body = fmt::format(
      "<header>\n{}\n</header>\n<div class=\"columns\">\n{}<main "
      "id=\"page-content\">\n{}\n</main>\n"
      "</div>",
      inner_html(header), contents_html(main), inner_html(main));
  page.html =
      sheet_html(page.title, body,
                 options.look + (options.view.is_null() ? "" : embedded::view_look), scripts);
  for (const auto& [mark, picture] : later) {
    const std::size_t place = page.html.find(mark);
    if (place != std::string::npos) page.html.replace(place, mark.size(), picture);
  }
  return page;
}

std::string sheet_html(const std::string& title, const std::string& body, const std::string& look,
                       const std::vector<std::string>& scripts) {
  std::string elements;
  for (const std::string& script : scripts) elements += "<script>\n" + script + "</script>\n";
  return with_slots(embedded::sheet_template, {{"title", escape_html(title)},
                                               {"look", embedded::look + look},
                                               {"body", body},
                                               {"scripts", elements}});
}

}  // namespace ricochet::report
