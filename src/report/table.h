#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "src/core/fields.h"
#include "src/report/json.h"

namespace ricochet {

/// A cell of a table, or a value of a report. std::monostate: it is missing.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

inline bool is_missing(const Value& value) {
  return value.index() == 0;
}

/// The number, whole numbers and bool (0, 1), too; nothing for a text or a missing value.
std::optional<double> number_in(const Value& value);

/// Makes a value of anything that is one: a number, a text, an enumeration with names, an optional.
/// A number that is not finite is missing.
template <class T>
Value value_of(const T& x) {
  if constexpr (std::is_same_v<T, Value> || std::is_same_v<T, bool>) {
    return x;
  } else if constexpr (std::is_integral_v<T>) {
    return static_cast<std::int64_t>(x);
  } else if constexpr (std::is_floating_point_v<T>) {
    return std::isfinite(x) ? Value(static_cast<double>(x)) : Value();
  } else if constexpr (HasNames<T>) {
    return std::string(name_of(names_of(x), x));
  } else if constexpr (std::is_convertible_v<const T&, std::string_view>) {
    return std::string(std::string_view(x));
  } else if constexpr (std::is_same_v<T, std::nullopt_t>) {
    return {};
  } else {
    return x ? value_of(*x) : Value();
  }
}

/// What `get`, a member or a function, makes of an optional's value or of what a pointer leads to;
/// missing if there is none.
template <class Maybe, class Get>
Value value_of(const Maybe& maybe, const Get& get) {
  return maybe ? value_of(std::invoke(get, *maybe)) : Value();
}

/// A value as text: numbers by fmt's format, such as ".2f"; with a last %, as per cent without the
/// sign, ".0%" makes 12 of 0.123; with a last m, in thousandths, as mm of a length in m. Without a
/// format numbers have up to four digits. Zero has no sign; true is "yes", or "✓" by the format
/// "mark" (false: "✗"); a missing value is "". Throws std::logic_error for a format that does not
/// fit.
std::string text_of(const Value& value, std::string_view format = "");

struct Column {
  std::string name;         ///< in data.json, CSV and queries
  std::string title = {};   ///< for readers, with its unit; empty: the name
  std::string format = {};  ///< see text_of()
  int digits = 6;           ///< significant digits that data.json keeps
};

/// Columns that have nothing but names, which are given with commas between.
std::vector<Column> columns_named(std::string_view names);

struct Table;

/// A row of a table, which must outlive it. All functions throw std::logic_error for a column that
/// the table does not have.
class Row {
 public:
  Row(const Table& table, std::size_t index) : table_(&table), index_(index) {}

  const Value& operator[](std::string_view column) const;

  /// Throws std::logic_error if it is not a number.
  double number(std::string_view column) const;
  std::optional<double> number_if(std::string_view column) const;
  /// The text; "" if it is missing. Throws std::logic_error if it is not a text.
  std::string text(std::string_view column) const;
  /// Whether the value is true. Missing is false.
  bool is(std::string_view column) const;

 private:
  const Table* table_;
  std::size_t index_;
};

/// Rows of named, typed columns. Everything that ricochet prints, exports or shows on a page as a
/// table is one of these, and the functions below are its writers.
struct Table {
  std::string name;  ///< lower-case letters, digits and hyphens: the name of its CSV file
  std::vector<Column> columns = {};
  std::vector<std::vector<Value>> rows = {};  ///< each as long as `columns`

  /// Adds a row of anything that value_of() takes. Throws std::logic_error unless there is a cell
  /// for each column.
  template <class... Cells>
  void add(const Cells&... cells) {
    add_row({value_of(cells)...});
  }
  void add_row(std::vector<Value> row);

  bool has(std::string_view column) const;
  /// The index of a column. Throws std::logic_error, which names the table, if there is none.
  std::size_t index_of(std::string_view column) const;
  Row operator[](std::size_t row) const { return {*this, row}; }
  /// The row of which this is true first; nothing if there is none.
  std::optional<Row> find(const std::function<bool(const Row&)>& is_it) const;
};

/// Calls `use` with each row.
template <class Use>
void each_row(const Table& table, const Use& use) {
  for (std::size_t i = 0; i < table.rows.size(); ++i) use(table[i]);
}

/// The rows of which `keep` is true.
Table where(const Table& table, const std::function<bool(const Row&)>& keep);
/// The rows whose column has this value.
Table where(const Table& table, std::string_view column, const Value& value);

/// Only these columns, in this order.
Table only(const Table& table, const std::vector<std::string>& columns);

/// Stably sorted by these columns; a name after a minus descends. Missing values come last, numbers
/// before texts.
Table sorted(Table table, const std::vector<std::string>& by);

/// Adds a column of what `make` returns for each row.
Table with(Table table, Column column, const std::function<Value(const Row&)>& make);

/// What aggregated() computes of the values of a column in a group.
struct Aggregate {
  Column column;   ///< the result's
  std::string of;  ///< the column whose values are taken; may be empty for count_of
  std::function<Value(const std::vector<Value>&)> function;
};

// Functions of the values of a group. Missing values are left out, except by count_of.
Value count_of(const std::vector<Value>& values);
Value sum_of(const std::vector<Value>& values);  ///< whole of whole numbers; 0 of none
Value least_of(const std::vector<Value>& values);
Value most_of(const std::vector<Value>& values);
Value mean_of(const std::vector<Value>& values);
Value median_of(const std::vector<Value>& values);  ///< of an even number: the middle of two

/// A row for each group of rows with equal values in the columns `by`, in the order in which groups
/// first occur.
Table aggregated(const Table& table, const std::vector<std::string>& by,
                 const std::vector<Aggregate>& aggregates);

/// Adds to every row of `left` the other columns of the first row of `right` that has the same
/// values in the columns `on`; missing values where there is none.
Table joined(const Table& left, const Table& right, const std::vector<std::string>& on);

/// What of a table is written: a table whose rows do not fit into memory is written by its head
/// and, batch by batch, its rows.
enum class Lines { all, head, rows };

/// As a CSV file (RFC 4180) with the columns' names, for other programs: numbers read back to the
/// same bits, or are inf or nan; bools are 1 and 0; missing values are empty, and no text is read
/// as one, see label().
std::string csv_of(const Table& table, Lines lines = Lines::all);

/// A list of objects, one for each row, by the columns' names. Numbers keep all their digits;
/// missing values, and numbers that are not finite, are null.
report::Json json_rows_of(const Table& table);

/// As a LaTeX tabular with the columns' titles and formats; needs textcomp and T1 fonts. Its head
/// and its rows alone are lines for any table.
std::string latex_of(const Table& table, Lines lines = Lines::all);

/// The text as one line, in which nothing is a command of LaTeX.
std::string escape_latex(std::string_view text);

/// As a GitHub table with the columns' titles and formats, texts to the left, at most `most` rows.
std::string markdown_of(const Table& table, std::size_t most = SIZE_MAX, Lines lines = Lines::all);

/// For a terminal: aligned columns, two blanks between them; titles are broken into lines where the
/// cells are narrow. Lines longer than `width` bytes are cut and end in "...".
std::string terminal_text_of(const Table& table, std::size_t width = SIZE_MAX);

}  // namespace ricochet
