#include "src/report/table_template.h"

#include <fmt/format.h>

namespace ricochet::report {
namespace {

/// One column of the page; a column of the template may produce several.
struct PlacedColumn {
  const Part* part;
  std::size_t entry;  ///< index in the list that repeats it
  Scopes scopes;      ///< with that entry
};

Cell cell_of(const PlacedColumn& column, const Json& row) {
  Scopes in_cell = with(column.scopes, row);
  if (column.part->has("cells")) {
    in_cell.push_back(&found_in(in_cell, column.part->text("cells")).at(column.entry));
  }
  Cell cell{filled(column.part->text("value"), in_cell)};
  if (column.part->has("state")) {
    const Json& state = found_in(in_cell, column.part->text("state"));
    if (!state.is_null()) cell.state = state.get<bool>() ? State::good : State::bad;
  }
  cell.link = column.part->filled_text("link", in_cell);
  return cell;
}

}  // namespace

Table table_of(const Part& part, const Scopes& scopes) {
  Table table{filled(part.text("caption"), scopes), {}, {}};
  const std::vector<Part> columns = part.parts("columns");
  std::vector<PlacedColumn> placed;
  for (const Part& column : columns) {
    const std::vector<Scopes> places = places_of(column, scopes);
    for (std::size_t i = 0; i < places.size(); ++i) {
      table.columns.push_back({filled(column.text("title"), places[i]),
                               column.has("align") && column.text("align") == "left"
                                   ? Alignment::left
                                   : Alignment::right});
      placed.push_back({&column, i, places[i]});
    }
  }
  if (const toml::array* rows = part.list("rows")) {
    for (const toml::node& row : *rows) {
      auto& cells = table.rows.emplace_back();
      for (const toml::node& text : *row.as_array()) {
        cells.push_back({filled(text.value<std::string>().value(), scopes)});
      }
    }
    return table;
  }
  const Json& rows = found_in(scopes, part.text("rows"));
  const auto most = part.number("most", scopes);
  for (const Json& row : rows) {
    if (most && static_cast<double>(table.rows.size()) >= *most) break;
    auto& cells = table.rows.emplace_back();
    for (const PlacedColumn& column : placed) cells.push_back(cell_of(column, row));
  }
  if (table.rows.size() < rows.size()) {
    const std::string all =
        part.has("csv") ? "; all are in " + part.filled_text("csv", scopes) + ".csv" : "";
    table.caption += fmt::format(" The first {} of {}{}.", table.rows.size(), rows.size(), all);
  }
  return table;
}

}  // namespace ricochet::report
