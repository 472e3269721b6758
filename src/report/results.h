#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/report/chart.h"
#include "src/report/json.h"
#include "src/report/table.h"

namespace ricochet::report {

struct Part;

/// What a page is filled with, and what its data.json holds: values, tables and charts, each under
/// its name. A part has results of its own.
struct Results {
  std::vector<std::pair<std::string, Value>> values = {};
  std::vector<ricochet::Table> tables = {};
  std::vector<Chart> charts = {};
  std::map<std::string, std::vector<Part>> parts = {};
  /// If true, a name that these results do not have is a missing value or an empty table, and no
  /// error: the results are of several reports, of which some may not be there, or of another
  /// version.
  bool open = false;

  /// Sets a value to anything that value_of() takes. A value that may be missing must be set, too.
  template <class T>
  void set(std::string name, const T& value) {
    values.emplace_back(std::move(name), value_of(value));
  }
  void add(ricochet::Table table) { tables.push_back(std::move(table)); }
  void add(Chart chart) { charts.push_back(std::move(chart)); }
  void add(const std::string& list, Part part);

  // Null if there is none of that name.
  const Value* value(std::string_view name) const;
  const ricochet::Table* table(std::string_view name) const;
  const Chart* chart(std::string_view name) const;
};

/// One of the parts among which a reader chooses: a solver, a family, a case.
struct Part {
  std::string id;     ///< its address on the page: letters, digits and hyphens
  std::string title;  ///< as the chooser has it
  Results results;
};

/// {"values": {name: value}, "tables": {name: {"columns": [{"name", "title", "format"}], "rows":
/// [[cell]]}}, "charts": {name: chart}, "parts": {name: [{"id", "title", "values", ...}]}}, all
/// with the digits that data.json keeps: six, or those of a column. What is empty is left out.
Json json_of(const Results& results);

/// Inverse of json_of(). Throws Json::exception or std::logic_error if it is none.
Results results_in(const Json& json);

}  // namespace ricochet::report
