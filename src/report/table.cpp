#include "src/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace ricochet {

std::optional<double> number_in(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* yes = std::get_if<bool>(&value)) return *yes ? 1 : 0;
  return {};
}

namespace {

std::string number_text(double number, std::string format) {
  double scale = 1;
  if (format.ends_with('%')) {
    scale = 100;
    format.back() = 'f';
  } else if (format.ends_with('m')) {
    scale = 1000;
    format.pop_back();
  }
  const std::string spec = "{:" + (format.empty() ? ".4g" : format) + "}";
  const auto text = [&](double x) { return fmt::format(fmt::runtime(spec), x); };
  const std::string exact = text(scale * number);
  return exact == text(-0.0) ? text(0.0) : exact;
}

}  // namespace

std::string text_of(const Value& value, std::string_view format) {
  const bool fraction = format.find_first_of("eEfFgG%.") != std::string_view::npos;
  try {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* yes = std::get_if<bool>(&value)) {
      if (format == "mark") return *yes ? "✓" : "✗";
      return *yes ? "yes" : "no";
    }
    if (const auto* whole = std::get_if<std::int64_t>(&value); whole != nullptr && !fraction) {
      return fmt::format(fmt::runtime("{:" + std::string(format) + "}"), *whole);
    }
    if (const auto number = number_in(value)) return number_text(*number, std::string(format));
  } catch (const fmt::format_error& error) {
    throw std::logic_error(fmt::format("a number as {}: {}", format, error.what()));
  }
  return "";
}

std::vector<Column> columns_named(std::string_view names) {
  std::vector<Column> columns;
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find(',', begin), names.size());
    columns.push_back({std::string(names.substr(begin, end - begin))});
    begin = end + 1;
  }
  return columns;
}

const Value& Row::operator[](std::string_view column) const {
  return table_->rows[index_][table_->index_of(column)];
}

double Row::number(std::string_view column) const {
  if (const auto number = number_if(column)) return *number;
  throw std::logic_error(
      fmt::format("table {}: {} is no number in row {}", table_->name, column, index_));
}

std::optional<double> Row::number_if(std::string_view column) const {
  return number_in((*this)[column]);
}

std::string Row::text(std::string_view column) const {
  const Value& value = (*this)[column];
  if (is_missing(value)) return "";
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  throw std::logic_error(
      fmt::format("table {}: {} is no text in row {}", table_->name, column, index_));
}

bool Row::is(std::string_view column) const {
  const auto* yes = std::get_if<bool>(&(*this)[column]);
  return yes != nullptr && *yes;
}

void Table::add_row(std::vector<Value> row) {
  if (row.size() != columns.size()) {
    throw std::logic_error(fmt::format("table {}: a row of {} cells for {} columns", name,
                                       row.size(), columns.size()));
  }
  rows.push_back(std::move(row));
}

bool Table::has(std::string_view column) const {
  return std::ranges::find(columns, column, &Column::name) != columns.end();
}

std::size_t Table::index_of(std::string_view column) const {
  const auto found = std::ranges::find(columns, column, &Column::name);
  if (found == columns.end()) {
    throw std::logic_error(fmt::format("table {}: there is no column {}", name, column));
  }
  return static_cast<std::size_t>(found - columns.begin());
}

std::optional<Row> Table::find(const std::function<bool(const Row&)>& is_it) const {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (is_it((*this)[i])) return (*this)[i];
  }
  return {};
}

Table where(const Table& table, const std::function<bool(const Row&)>& keep) {
  Table kept{table.name, table.columns};
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (keep(table[i])) kept.rows.push_back(table.rows[i]);
  }
  return kept;
}

Table where(const Table& table, std::string_view column, const Value& value) {
  const std::size_t index = table.index_of(column);
  Table kept{table.name, table.columns};
  std::ranges::copy_if(table.rows, std::back_inserter(kept.rows),
                       [&](const auto& row) { return row[index] == value; });
  return kept;
}

Table only(const Table& table, const std::vector<std::string>& columns) {
  Table kept{table.name};
  std::vector<std::size_t> indices;
  for (const std::string& column : columns) {
    indices.push_back(table.index_of(column));
    kept.columns.push_back(table.columns[indices.back()]);
  }
  for (const auto& row : table.rows) {
    std::vector<Value> cells;
    for (const std::size_t index : indices) cells.push_back(row[index]);
    kept.rows.push_back(std::move(cells));
  }
  return kept;
}

namespace {

/// Less than zero where a comes before b.
int order_of(const Value& a, const Value& b, bool descends) {
  const auto kind = [](const Value& value) {
    return is_missing(value) ? 2 : std::holds_alternative<std::string>(value) ? 1 : 0;
  };
  if (kind(a) != kind(b) || kind(a) == 2) return kind(a) - kind(b);
  const auto sign = [](const auto& x, const auto& y) { return x < y ? -1 : y < x ? 1 : 0; };
  const int rising = kind(a) == 1 ? sign(std::get<std::string>(a), std::get<std::string>(b))
                                  : sign(*number_in(a), *number_in(b));
  return descends ? -rising : rising;
}

}  // namespace

Table sorted(Table table, const std::vector<std::string>& by) {
  std::vector<std::pair<std::size_t, bool>> keys;
  for (const std::string& key : by) {
    const bool descends = key.starts_with('-');
    keys.emplace_back(table.index_of(descends ? key.substr(1) : key), descends);
  }
  std::ranges::stable_sort(table.rows, [&](const auto& a, const auto& b) {
    for (const auto& [index, descends] : keys) {
      if (const int order = order_of(a[index], b[index], descends); order != 0) return order < 0;
    }
    return false;
  });
  return table;
}

Table with(Table table, Column column, const std::function<Value(const Row&)>& make) {
  std::vector<Value> cells;
  each_row(table, [&](const Row& row) { cells.push_back(make(row)); });
  table.columns.push_back(std::move(column));
  for (std::size_t i = 0; i < cells.size(); ++i) table.rows[i].push_back(std::move(cells[i]));
  return table;
}

namespace {

std::vector<double> numbers_in(const std::vector<Value>& values) {
  std::vector<double> numbers;
  for (const Value& value : values) {
    if (const auto number = number_in(value)) numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

Value count_of(const std::vector<Value>& values) {
  return static_cast<std::int64_t>(values.size());
}

Value sum_of(const std::vector<Value>& values) {
  double sum = 0;
  bool whole = true;
  for (const Value& value : values) {
    sum += number_in(value).value_or(0);
    whole = whole && !std::holds_alternative<double>(value);
  }
  return whole ? Value(static_cast<std::int64_t>(sum)) : Value(sum);
}

Value least_of(const std::vector<Value>& values) {
  const auto numbers = numbers_in(values);
  return numbers.empty() ? Value() : *std::ranges::min_element(numbers);
}

Value most_of(const std::vector<Value>& values) {
  const auto numbers = numbers_in(values);
  return numbers.empty() ? Value() : *std::ranges::max_element(numbers);
}

Value mean_of(const std::vector<Value>& values) {
  const auto numbers = numbers_in(values);
  double sum = 0;
  for (const double number : numbers) sum += number;
  return numbers.empty() ? Value() : sum / static_cast<double>(numbers.size());
}

Value median_of(const std::vector<Value>& values) {
  auto numbers = numbers_in(values);
  if (numbers.empty()) return {};
  std::ranges::sort(numbers);
  const std::size_t middle = numbers.size() / 2;
  return numbers.size() % 2 == 1 ? numbers[middle] : (numbers[middle - 1] + numbers[middle]) / 2;
}

namespace {

std::vector<Value> cells_of(const std::vector<Value>& row, const std::vector<std::size_t>& at) {
  std::vector<Value> cells;
  for (const std::size_t index : at) cells.push_back(row[index]);
  return cells;
}

std::vector<std::size_t> indices_of(const Table& table, const std::vector<std::string>& columns) {
  std::vector<std::size_t> indices;
  for (const std::string& column : columns) indices.push_back(table.index_of(column));
  return indices;
}

}  // namespace

Table aggregated(const Table& table, const std::vector<std::string>& by,
                 const std::vector<Aggregate>& aggregates) {
  Table result{table.name};
  const auto keys = indices_of(table, by);
  for (const std::size_t key : keys) result.columns.push_back(table.columns[key]);
  for (const Aggregate& one : aggregates) result.columns.push_back(one.column);
  std::map<std::vector<Value>, std::size_t> places;
  std::vector<std::vector<const std::vector<Value>*>> groups;
  for (const auto& row : table.rows) {
    const auto [place, is_new] = places.try_emplace(cells_of(row, keys), groups.size());
    if (is_new) groups.emplace_back();
    groups[place->second].push_back(&row);
  }
  for (const auto& group : groups) {
    std::vector<Value> cells = cells_of(*group.front(), keys);
    for (const Aggregate& one : aggregates) {
      const std::size_t index = one.of.empty() ? 0 : table.index_of(one.of);
      std::vector<Value> values;
      for (const auto* row : group) values.push_back((*row)[index]);
      cells.push_back(one.function(values));
    }
    result.add_row(std::move(cells));
  }
  return result;
}

Table joined(const Table& left, const Table& right, const std::vector<std::string>& on) {
  Table result = left;
  const auto keys = indices_of(left, on), right_keys = indices_of(right, on);
  std::vector<std::size_t> added;
  for (std::size_t i = 0; i < right.columns.size(); ++i) {
    if (std::ranges::find(right_keys, i) != right_keys.end()) continue;
    added.push_back(i);
    result.columns.push_back(right.columns[i]);
  }
  std::map<std::vector<Value>, const std::vector<Value>*> places;
  for (const auto& row : right.rows) places.try_emplace(cells_of(row, right_keys), &row);
  for (auto& row : result.rows) {
    const auto found = places.find(cells_of(row, keys));
    for (const std::size_t index : added) {
      row.push_back(found == places.end() ? Value() : (*found->second)[index]);
    }
  }
  return result;
}

}  // namespace ricochet
