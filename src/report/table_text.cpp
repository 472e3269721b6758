#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

#include "src/core/csv.h"
#include "src/core/names.h"
#include "src/report/table.h"
#include "src/report/text.h"

namespace ricochet {

namespace {

const std::string& title_of(const Column& column) {
  return column.title.empty() ? column.name : column.title;
}

/// Whether a column has texts, which stand to the left.
bool is_left(const Table& table, std::size_t column) {
  return std::ranges::any_of(table.rows, [&](const auto& row) {
    return std::holds_alternative<std::string>(row[column]);
  });
}

std::string csv_cell(const Value& value) {
  if (is_missing(value)) return "";
  if (const auto* number = std::get_if<double>(&value)) return fmt::to_string(*number);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::to_string(*whole);
  if (const auto* yes = std::get_if<bool>(&value)) return *yes ? "1" : "0";
  return csv_field(label(one_line(text_of(value))));
}

/// A table as lines.
struct Written {
  std::string head, rows;

  std::string of(Lines lines) const {
    return lines == Lines::head ? head : lines == Lines::rows ? rows : head + rows;
  }
};

/// What stands before, between and after the cells of a line.
struct Marks {
  std::string before, between, after;
};

template <class Title, class Cell>
Written written(const Table& table, const Marks& marks, const Title& title, const Cell& cell,
                std::size_t most = SIZE_MAX) {
  const auto line = [&](const auto& text) {
    std::string joined = marks.before;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      joined += (k > 0 ? marks.between : "") + text(k);
    }
    return joined + marks.after;
  };
  Written result{line([&](std::size_t k) { return title(table.columns[k], k); }), ""};
  for (std::size_t i = 0; i < std::min(most, table.rows.size()); ++i) {
    result.rows += line([&](std::size_t k) { return cell(table.rows[i][k], table.columns[k], k); });
  }
  return result;
}

/// With titles and cells as `escaped` makes them of texts.
template <class Escape>
Written written(const Table& table, const Marks& marks, const Escape& escaped, std::size_t most) {
  return written(
      table, marks, [&](const Column& column, std::size_t) { return escaped(title_of(column)); },
      [&](const Value& value, const Column& column, std::size_t) {
        return escaped(text_of(value, column.format));
      },
      most);
}

}  // namespace

std::string escape_latex(std::string_view text) {
  // After the end of a row LaTeX would read [ and * as part of it.
  static const std::map<char, std::string> escapes = {{'\\', "\\textbackslash{}"},
                                                      {'~', "\\textasciitilde{}"},
                                                      {'^', "\\textasciicircum{}"},
                                                      {'<', "\\textless{}"},
                                                      {'>', "\\textgreater{}"},
                                                      {'|', "\\textbar{}"},
                                                      {'"', "\\textquotedbl{}"},
                                                      {'\'', "\\textquotesingle{}"},
                                                      {'`', "\\textasciigrave{}"},
                                                      {'[', "{[}"},
                                                      {'*', "{*}"}};
  std::string tex;
  for (const char c : one_line(text)) {
    const auto found = escapes.find(c);
    if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) tex += '\\';
    if (c == '-' && tex.ends_with('-')) tex += "{}";  // two of them would be one dash
    tex += found == escapes.end() ? std::string(1, c) : found->second;
  }
  return tex;
}

std::string csv_of(const Table& table, Lines lines) {
  return written(
             table, {"", ",", "\n"},
             [](const Column& column, std::size_t) { return csv_field(one_line(column.name)); },
             [](const Value& value, const Column&, std::size_t) { return csv_cell(value); })
      .of(lines);
}

report::Json json_rows_of(const Table& table) {
  return report::list_of(table.rows, [&](const std::vector<Value>& row) {
    report::Json object = report::Json::object();
    for (std::size_t k = 0; k < row.size(); ++k) {
      object[table.columns[k].name] = std::visit(
          [](const auto& x) {
            if constexpr (std::is_same_v<std::decay_t<decltype(x)>, std::monostate>) {
              return report::Json();
            } else {
              return report::as_json(x);
            }
          },
          row[k]);
    }
    return object;
  });
}

std::string latex_of(const Table& table, Lines lines) {
  const Written text = written(table, {"", " & ", " \\\\\n"}, escape_latex, SIZE_MAX);
  if (lines != Lines::all) return text.of(lines);
  std::string alignment;
  for (std::size_t k = 0; k < table.columns.size(); ++k) alignment += is_left(table, k) ? 'l' : 'r';
  return fmt::format("\\begin{{tabular}}{{{}}}\n\\hline\n{}\\hline\n{}\\hline\n\\end{{tabular}}\n",
                     alignment, text.head, text.rows);
}

std::string markdown_of(const Table& table, std::size_t most, Lines lines) {
  Written text = written(table, {"| ", " | ", " |\n"}, report::escape_markdown, most);
  text.head += "|";
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    text.head += is_left(table, k) ? ":--|" : "--:|";
  }
  text.head += "\n";
  return text.of(lines);
}

namespace {

/// Columns of a terminal, as fmt counts them when it pads: one for a letter of several bytes.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// A title in lines no wider than `room`, its widest word or a usual number.
std::vector<std::string> in_lines(const std::string& title, std::size_t room) {
  constexpr std::size_t usual = 9;
  room = std::max(room, usual);
  std::vector<std::string> words;
  std::istringstream text(title);
  for (std::string word; text >> word;) words.push_back(word);
  for (const std::string& word : words) room = std::max(room, width_of(word));
  std::vector<std::string> lines(1);
  for (const std::string& word : words) {
    std::string& last = lines.back();
    if (last.empty()) {
      last = word;
    } else if (width_of(last) + 1 + width_of(word) <= room) {
      last += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace

std::string terminal_text_of(const Table& table, std::size_t width) {
  std::vector<std::vector<std::string>> columns;
  std::size_t height = 0;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    std::size_t widest = 0;
    std::vector<std::string> cells;
    for (const auto& row : table.rows) {
      cells.push_back(one_line(text_of(row[k], table.columns[k].format)));
      widest = std::max(widest, width_of(cells.back()));
    }
    std::vector<std::string>& lines =
        columns.emplace_back(in_lines(title_of(table.columns[k]), widest));
    lines.insert(lines.end(), cells.begin(), cells.end());
    for (const std::string& line : lines) widest = std::max(widest, width_of(line));
    const char* const form = is_left(table, k) ? "{:<{}}" : "{:>{}}";
    for (std::string& line : lines) line = fmt::format(fmt::runtime(form), line, widest);
    height = std::max(height, lines.size());
  }
  std::vector<std::string> padded(height);
  for (const auto& lines : columns) {
    const std::size_t above = height - lines.size();
    for (std::size_t i = 0; i < height; ++i) {
      if (&lines != &columns.front()) padded[i] += "  ";
      padded[i] += i < above ? std::string(width_of(lines.front()), ' ') : lines[i - above];
    }
  }
  constexpr std::string_view cut = "...";
  std::string text;
  for (std::string& line : padded) {
    line.erase(line.find_last_not_of(' ') + 1);
    if (line.size() > width) {
      line.resize(width - std::min(width, cut.size()));
      line += cut;
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace ricochet
