#include "src/report/table.h"

#include <fmt/format.h>

#include <stdexcept>

#include "src/report/text.h"

namespace ricochet::report {
namespace {

void check(const Table& table) {
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    if (table.rows[i].size() != table.columns.size())
      throw std::invalid_argument(fmt::format("table \"{}\", row {}: {} cells for {} columns",
                                              table.caption, i, table.rows[i].size(),
                                              table.columns.size()));
}

const char* alignment_class(const Column& column) {
  return column.alignment == Alignment::left ? "left" : "right";
}

std::string html_content(const Cell& cell) {
  static constexpr const char* mark = "<span role=\"img\" aria-label=\"{}\">{}</span> {}";
  const std::string text = escape_html(cell.text);
  switch (cell.state) {
    case State::good:
      return fmt::format(mark, "good", "✓", text);
    case State::bad:
      return fmt::format(mark, "bad", "✗", text);
    case State::neutral:
      break;
  }
  return text;
}

const char* state_class(State state) {
  return state == State::good ? " good" : state == State::bad ? " bad" : "";
}

}  // namespace

std::string to_markdown(const Table& table) {
  check(table);
  std::string text = escape_markdown(table.caption) + "\n\n|";
  for (const Column& column : table.columns)
    text += fmt::format(" {} |", escape_markdown(column.title));
  text += "\n|";
  for (const Column& column : table.columns)
    text += column.alignment == Alignment::left ? " :--- |" : " ---: |";
  for (const auto& row : table.rows) {
    text += "\n|";
    for (const Cell& cell : row) {
      text += cell.state == State::good ? " ✓" : cell.state == State::bad ? " ✗" : "";
      text += fmt::format(" {} |", escape_markdown(cell.text));
    }
  }
  return text + "\n";
}

std::string to_html(const Table& table) {
  check(table);
  std::string html =
      fmt::format("<table>\n<caption>{}</caption>\n<thead><tr>", html_with_links(table.caption));
  for (const Column& column : table.columns)
    html += fmt::format("<th scope=\"col\" class=\"{}\">{}</th>", alignment_class(column),
                        escape_html(column.title));
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      html += fmt::format("<{0}{1} class=\"{2}{3}\">{4}</{0}>", i == 0 ? "th" : "td",
                          i == 0 ? " scope=\"row\"" : "", alignment_class(table.columns[i]),
                          state_class(row[i].state), html_content(row[i]));
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n";
}

}  // namespace ricochet::report
