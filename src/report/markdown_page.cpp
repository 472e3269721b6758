#include "src/report/markdown_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "src/report/drawing.h"
#include "src/report/markdown_html.h"
#include "src/report/text.h"

namespace ricochet::report {

namespace {

std::string trimmed(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t");
  if (start == std::string_view::npos) return "";
  return std::string(text.substr(start, text.find_last_not_of(" \t") + 1 - start));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

PageSource page_source(std::string_view file) {
  const std::size_t end = file.find("\n---\n", 3);
  if (!file.starts_with("---\n") || end == std::string_view::npos)
    throw std::logic_error("a page must begin with its keys, between lines of ---");
  PageSource page;
  for (const std::string& line : lines_of(std::string(file.substr(4, end - 3)))) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) throw std::logic_error("a page's key without a colon: " + line);
    page.keys[line.substr(0, colon)] = trimmed(line.substr(colon + 1));
  }
  page.text = file.substr(end + 5);
  return page;
}

namespace {

/// A block of lines, or blocks that are chosen or folded.
struct Node {
  enum class Kind { block, choose, fold } kind;
  std::vector<std::string> lines = {};
  std::string name = {}, label = {};  ///< of the parts; of the chooser, or the fold's heading
  std::vector<Node> children = {};
};

/// The rest of a line {{word rest}}; nothing if it is another line.
std::optional<std::string> directive(const std::string& line, std::string_view word) {
  const std::string opening = "{{" + std::string(word);
  if (!line.starts_with(opening) || !line.ends_with("}}")) return {};
  const std::string inside = line.substr(opening.size(), line.size() - opening.size() - 2);
  if (!inside.empty() && inside.front() != ' ') return {};
  return trimmed(inside);
}

std::vector<Node> nodes_of(const std::string& text) {
  std::vector<Node> open = {{Node::Kind::fold}};
  bool in_code = false, joins = false;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("```")) in_code = !in_code;
    if (const auto fold = directive(line, "fold"); fold && !in_code) {
      open.push_back({Node::Kind::fold, {}, "", *fold});
    } else if (const auto choose = directive(line, "choose"); choose && !in_code) {
      const std::size_t colon = std::min(choose->find(':'), choose->size() - 1);
      open.push_back(
          {Node::Kind::choose, {}, choose->substr(0, colon), trimmed(choose->substr(colon + 1))});
    } else if (line == "{{end}}" && open.size() > 1) {
      Node done = std::move(open.back());
      open.pop_back();
      open.back().children.push_back(std::move(done));
    } else if (line.empty() && !in_code) {
      joins = false;
      continue;
    } else {
      auto& blocks = open.back().children;
      if (!joins || blocks.empty()) blocks.push_back({Node::Kind::block});
      blocks.back().lines.push_back(line);
      joins = true;
      continue;
    }
    joins = false;
  }
  if (open.size() != 1) throw std::logic_error("a page's chooser or fold has no {{end}}");
  return std::move(open.back().children);
}

/// What names on a page stand for: the results of the innermost part last, and a row of a table.
struct Scope {
  std::vector<const Results*> results;
  std::string path = {};  ///< ids of the parts, each with a hyphen: begins the charts' file names
  const ricochet::Table* table = nullptr;
  std::size_t row = 0;

  template <class T>
  const T* find(const T* (Results::*in)(std::string_view) const, std::string_view name) const {
    for (auto one = results.rbegin(); one != results.rend(); ++one)
      if (const T* found = ((*one)->*in)(name)) return found;
    return nullptr;
  }

  const ricochet::Table* find_table(std::string_view name) const {
    return find(&Results::table, name);
  }

  bool open() const { return results.front()->open; }

  /// The table of "table.column"; null if it is no such name.
  const ricochet::Table* table_of(std::string_view name) const {
    const std::size_t dot = name.find('.');
    if (dot == std::string_view::npos || find(&Results::value, name) != nullptr) return nullptr;
    return find_table(name.substr(0, dot));
  }

  const Value& value(const std::string& name) const {
    static const Value missing;
    if (table != nullptr && name.starts_with(table->name + ".")) {
      const std::string column = name.substr(table->name.size() + 1);
      return open() && !table->has(column) ? missing : (*table)[row][column];
    }
    if (const Value* found = find(&Results::value, name)) return *found;
    if (open()) return missing;
    throw std::logic_error(fmt::format("a page asks for {}, which the results do not have", name));
  }
};

/// A text up to a {{name:format}} in it, and that name; the last piece has none.
struct Piece {
  std::string_view before;
  std::string name = {};
  std::string_view format = {};
};

std::vector<Piece> pieces_of(std::string_view text) {
  std::vector<Piece> pieces;
  while (true) {
    const std::size_t start = text.find("{{");
    const std::size_t end = start == text.npos ? start : text.find("}}", start);
    if (end == text.npos) break;
    const std::string_view inside = text.substr(start + 2, end - start - 2);
    const std::size_t colon = std::min(inside.find(':'), inside.size());
    pieces.push_back({text.substr(0, start), std::string(inside.substr(0, colon)),
                      inside.substr(std::min(colon + 1, inside.size()))});
    text.remove_prefix(end + 2);
  }
  pieces.push_back({text});
  return pieces;
}

/// Fills in a text; nothing if a value is missing.
std::optional<std::string> filled(std::string_view text, const Scope& scope, bool escapes) {
  std::string result;
  bool complete = true;
  for (const Piece& piece : pieces_of(text)) {
    result += piece.before;
    if (piece.name.empty()) continue;
    const Value& value = scope.value(piece.name);
    complete = complete && !is_missing(value);
    const std::string shown = ricochet::text_of(value, piece.format);
    const bool in_code = std::ranges::count(result, '`') % 2 == 1;
    result += escapes && !in_code ? escape_markdown(shown) : shown;
  }
  if (!complete) return {};
  return result;
}

bool is_row(const std::string& line) {
  return line.starts_with('|');
}

bool is_item(const std::string& line) {
  return line.starts_with("- ") || line.starts_with("1. ");
}

/// The line with its cells filled in; a cell with a missing value is empty.
std::string filled_cells(const std::string& line, const Scope& scope) {
  std::string result = "|";
  std::size_t start = 1;
  while (start < line.size()) {
    const std::size_t end = std::min(line.find('|', start), line.size());
    const auto cell = filled(std::string_view(line).substr(start, end - start), scope, true);
    result += (cell ? *cell : " ") + (end < line.size() ? "|" : "");
    start = end + 1;
  }
  return result;
}

std::optional<std::string> filled_one(const std::string& line, const Scope& scope) {
  if (is_row(line)) return filled_cells(line, scope);
  return filled(line, scope, true);
}

/// The table whose rows a line repeats; null if it repeats none.
const ricochet::Table* repeated_in(const std::string& line, const Scope& scope) {
  if (!is_row(line) && !is_item(line)) return nullptr;
  for (const Piece& piece : pieces_of(line))
    if (const ricochet::Table* table = scope.table_of(piece.name)) return table;
  return nullptr;
}

/// Whether all that a line asks for is missing, and it asks for something.
bool asks_in_vain(const std::string& line, const Scope& scope) {
  const auto pieces = pieces_of(line);
  return pieces.size() > 1 && std::ranges::all_of(pieces, [&](const Piece& piece) {
           return piece.name.empty() || is_missing(scope.value(piece.name));
         });
}

/// Says where the rows are that a page does not show.
std::string rest_of(const ricochet::Table& table, std::size_t most, const Scope& scope) {
  return fmt::format("\nThe first {} of {} rows; all are in {}.\n", most, table.rows.size(),
                     scope.path.empty() ? fmt::format("`{}.csv`", table.name) : "`data.json`");
}

std::string table_markdown(const std::string& what, const Scope& scope) {
  const std::size_t blank = std::min(what.find(' '), what.size());
  const std::string name = what.substr(0, blank);
  const ricochet::Table* table = scope.find_table(name);
  if (table == nullptr && scope.open()) return "";
  if (table == nullptr)
    throw std::logic_error("a page asks for the table " + name + ", which the results do not have");
  if (table->rows.empty()) return "";
  const std::string limit = trimmed(what.substr(blank));
  const std::size_t most = limit.empty() ? SIZE_MAX : std::stoul(limit);
  std::string text = markdown_of(*table, most);
  return table->rows.size() > most ? text + rest_of(*table, most, scope) : text;
}

/// A picture as Markdown, which is drawn when it is asked for.
using Draw = std::function<std::string(const Chart& chart)>;

class Filler {
 public:
  explicit Filler(Draw draw) : draw_(std::move(draw)) {}

  std::string page(const PageSource& source, const Results& results) const {
    std::string text;
    for (const std::string& block : blocks(nodes_of(source.text), {{&results}})) {
      text += (text.empty() ? "" : "\n") + block;
    }
    return text;
  }

 private:
  /// What a node makes, and whether it asks for something, and has it.
  struct Made {
    std::vector<std::string> blocks;
    std::size_t level = 0;  ///< of a heading
    bool asks = false;
  };

  std::vector<std::string> blocks(const std::vector<Node>& nodes, const Scope& scope) const {
    std::vector<Made> all;
    for (const Node& node : nodes) {
      Made& made = all.emplace_back();
      if (node.kind != Node::Kind::block) {
        made.blocks = node.kind == Node::Kind::choose ? chosen(node, scope) : folded(node, scope);
        made.asks = true;
        continue;
      }
      if (auto text = block(node.lines, scope); !text.empty())
        made.blocks.push_back(std::move(text));
      made.level = level_of(node.lines.front());
      made.asks = made.level == 0 && std::ranges::any_of(node.lines, [](const std::string& line) {
                    return line.find("{{") != std::string::npos;
                  });
    }
    drop_empty_sections(all);
    std::vector<std::string> kept;
    for (const Made& made : all) kept.insert(kept.end(), made.blocks.begin(), made.blocks.end());
    return kept;
  }

  /// Empties the sections, below headings of the second level on, in which nothing is left, or that
  /// ask for something and have nothing of it.
  static void drop_empty_sections(std::vector<Made>& all) {
    for (std::size_t i = all.size(); i-- > 0;) {
      if (all[i].level < 2) continue;
      bool asks = false, has = false, is_left = false;
      std::size_t end = i + 1;
      for (; end < all.size() && (all[end].level == 0 || all[end].level > all[i].level); ++end) {
        asks = asks || all[end].asks;
        has = has || (all[end].asks && !all[end].blocks.empty());
        is_left = is_left || !all[end].blocks.empty();
      }
      if (is_left && (has || !asks)) continue;
      for (std::size_t k = i; k < end; ++k) all[k].blocks.clear();
    }
  }

  std::vector<std::string> chosen(const Node& node, const Scope& scope) const {
    const std::vector<Part>* parts = nullptr;
    for (const Results* results : scope.results) {
      const auto found = results->parts.find(node.name);
      if (found != results->parts.end()) parts = &found->second;
    }
    if (parts == nullptr || parts->empty()) return {};
    std::vector<std::string> all = {fmt::format("<!-- choose: {} -->\n", node.label)};
    for (const Part& part : *parts) {
      require_address(part.id);
      Scope inner = scope;
      inner.results.push_back(&part.results);
      inner.path += part.id + "-";
      all.push_back(
          fmt::format("<!-- part: {}{} {} -->\n", scope.path, part.id, in_comment(part.title)));
      const auto inside = blocks(node.children, inner);
      all.insert(all.end(), inside.begin(), inside.end());
    }
    all.emplace_back("<!-- end -->\n");
    return all;
  }

  std::vector<std::string> folded(const Node& node, const Scope& scope) const {
    std::vector<std::string> all = blocks(node.children, scope);
    const auto heading = filled(node.label, scope, false);
    if (all.empty() || !heading) return {};
    all.insert(all.begin(), fmt::format("<details><summary>{}</summary>\n", escape_html(*heading)));
    all.emplace_back("</details>\n");
    return all;
  }

  std::string block(const std::vector<std::string>& lines, const Scope& scope) const {
    if (lines.size() == 1) {
      if (lines[0] == "{{view}}") return std::string(view_mark) + "\n";
      if (const auto table = directive(lines[0], "table")) return table_markdown(*table, scope);
    }
    std::string text, rest;
    bool in_code = false;
    std::size_t most = SIZE_MAX;
    for (const std::string& line : lines) {
      if (line.starts_with("```")) in_code = !in_code;
      if (const auto limit = directive(line, "rows")) {
        most = std::stoul(*limit);
        continue;
      }
      if (const ricochet::Table* table = repeated_in(line, scope)) {
        if (table->rows.empty()) return "";
        if (table->rows.size() > most) rest = rest_of(*table, most, scope);
        for (std::size_t row = 0; row < std::min(most, table->rows.size()); ++row) {
          Scope at = scope;
          at.table = table;
          at.row = row;
          if (const auto one = filled_one(line, at)) text += *one + "\n";
        }
        continue;
      }
      const std::size_t names_end = line.find("}}");
      if (line.starts_with("{{chart ") && names_end != std::string::npos) {
        const Chart* chart = scope.find(&Results::chart, trimmed(line.substr(8, names_end - 8)));
        if (chart == nullptr) return "";
        Chart own = *chart;
        own.name = scope.path + own.name;
        text += draw_(own) + "\n";
        const auto caption = filled(trimmed(line.substr(names_end + 2)), scope, true);
        if (caption && !caption->empty()) text += *caption + "\n";
        continue;
      }
      const auto one = in_code ? filled(line, scope, false) : filled_one(line, scope);
      // A row that asks for a table which is not there.
      if (is_row(line) && !in_code && asks_in_vain(line, scope)) return "";
      if (!one && is_item(line)) continue;
      if (!one) return "";
      text += *one + "\n";
    }
    return text + rest;
  }

  /// Level of a block that is a heading; 0 if it is none.
  static std::size_t level_of(const std::string& block) {
    const std::size_t level = block.find_first_not_of('#');
    return level != std::string::npos && level > 0 && block[level] == ' ' ? level : 0;
  }

  static void require_address(const std::string& id) {
    const auto allowed = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             c == '-' || c == '_';
    };
    if (id.empty() || !std::ranges::all_of(id, allowed))
      throw std::logic_error(fmt::format("\"{}\" is no id of a part", id));
  }

  /// Two hyphens would end a comment.
  static std::string in_comment(const std::string& text) {
    std::string fit;
    for (const char c : text)
      if (c != '<' && c != '>' && !(c == '-' && fit.ends_with('-'))) fit += c;
    return fit;
  }

  Draw draw_;
};

// Documents and the live page are pages of the site, without a Markdown file.

/// Links to folders lead to their pages.
std::string with_files(const std::string& markdown) {
  static const std::regex own(R"(\]\(((\.\./)*(docs|live)/([^)#\n]*/)?)(#[^)\n]*)?\))");
  static const std::regex folder(R"(\]\((?!\w+://)([^)#\n]*/)(#[^)\n]*)?\))");
  return std::regex_replace(std::regex_replace(markdown, own, "]($1index.html$5)"), folder,
                            "]($1summary.md$2)");
}

/// A file of Markdown alone has no pages of a site beside it.
std::string without_the_site(const std::string& markdown) {
  static const std::regex own(R"(\[([^\[\]\n]*)\]\((\.\./)*(docs|live)/[^)\n]*\))");
  return std::regex_replace(markdown, own, "$1");
}

}  // namespace

std::string filled_line(std::string_view line, const Results& results) {
  return filled(line, {{&results}}, false).value_or("");
}

std::string title_of(const PageSource& page, const Results& results) {
  for (const std::string& line : lines_of(page.text))
    if (line.starts_with("# ")) return filled_line(line.substr(2), results);
  throw std::logic_error("a page has no title");
}

std::string filled_page(const PageSource& page, const Results& results) {
  const Filler filler([](const Chart& chart) {
    return markdown_of(DrawnChart{chart.name, chart.title, ""});
  });
  return with_files(filler.page(page, results));
}

std::string terminal_text(const PageSource& page, const Results& results) {
  const auto found = page.keys.find("terminal");
  if (found == page.keys.end()) return "";
  std::string text;
  std::istringstream names(found->second);
  for (std::string name; std::getline(names, name, ',');) {
    std::istringstream words(name);
    words >> name;
    std::vector<std::string> columns;
    for (std::string column; words >> column;) columns.push_back(column);
    if (const ricochet::Table* table = results.table(name)) {
      if (table->rows.empty()) continue;
      text += "\n" + terminal_text_of(columns.empty() ? *table : only(*table, columns));
    } else {
      const std::string line = filled_line("{{" + name + "}}", results);
      if (!line.empty()) text += line + "\n";
    }
  }
  return text;
}

PageFiles page_files(const PageSource& page, const Results& results,
                     const std::map<std::string, std::string>& further) {
  PageFiles written;
  std::map<std::string, Picture> pictures;
  for (const auto& [name, svg] : further) {
    pictures[name + ".svg"] = {Chart{.name = "", .width = 900}, DrawnChart{name, "", svg}};
    written.files[name + ".svg"] = svg;
  }
  const Filler filler([&](const Chart& chart) {
    DrawnChart drawn = draw(chart);
    if (drawn.is_drawn()) {
      written.files[chart.name + ".svg"] = drawn.svg;
    } else {
      written.failures.push_back(failure_of(drawn));
    }
    std::string markdown = markdown_of(drawn);
    if (drawn.is_drawn()) pictures[chart.name + ".svg"] = {chart, std::move(drawn)};
    return markdown;
  });
  std::string markdown = with_files(filler.page(page, results));
  for (const ricochet::Table& table : results.tables) {
    if (!table.rows.empty() && !table.name.starts_with("view-"))
      written.files[table.name + ".csv"] = csv_of(table);
  }
  Json view;
  for (const ricochet::Table& table : results.tables) {
    if (!table.name.starts_with("view-")) continue;
    view[table.name.substr(5)] = json_of(Results{{}, {table}})["tables"][table.name];
  }
  if (const Value* first = results.value("first_instance")) {
    view["first_instance"] = ricochet::number_in(*first).value_or(0);
  }
  if (const Value* command = results.value("command"); command != nullptr && !view.is_null()) {
    view["command"] = ricochet::text_of(*command);
  }
  written.files["index.html"] =
      html_page(markdown, {.pictures = std::move(pictures), .view = std::move(view)}).html;
  written.files["summary.md"] = without_the_site(markdown);
  return written;
}

}  // namespace ricochet::report
