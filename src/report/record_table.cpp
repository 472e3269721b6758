#include "src/report/record_table.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace ricochet::report {
namespace {

constexpr const char* columns = "columns";
constexpr const char* rows = "rows";

bool has_names_of_table(const Json& data) {
  return data.is_object() && data.size() == 2 && data.contains(columns) && data.contains(rows);
}

bool same_names(const Json& a, const Json& b) {
  return std::equal(a.items().begin(), a.items().end(), b.items().begin(), b.items().end(),
                    [](const auto& left, const auto& right) { return left.key() == right.key(); });
}

bool makes_table(const Json& list) {
  if (list.size() < 2 || !list[0].is_object() || list[0].empty()) return false;
  return std::ranges::all_of(
      list, [&](const Json& entry) { return entry.is_object() && same_names(entry, list[0]); });
}

Json table_of(const Json& list) {
  Json names = Json::array(), values = Json::array();
  for (const auto& [name, value] : list[0].items()) names.push_back(name);
  for (const Json& entry : list) {
    Json row = Json::array();
    for (const Json& value : entry) row.push_back(packed(value));
    values.push_back(std::move(row));
  }
  return {{columns, std::move(names)}, {rows, std::move(values)}};
}

bool is_table(const Json& data) {
  if (!has_names_of_table(data) || !data[columns].is_array() || !data[rows].is_array())
    return false;
  const auto is_name = [](const Json& name) { return name.is_string(); };
  return std::ranges::all_of(data[columns], is_name) &&
         std::ranges::all_of(data[rows], [&](const Json& row) {
           return row.is_array() && row.size() == data[columns].size();
         });
}

}  // namespace

Json packed(const Json& data) {
  if (!data.is_structured()) return data;
  if (has_names_of_table(data)) {
    throw std::logic_error("the data of a report have an object of only columns and rows");
  }
  if (data.is_array() && makes_table(data)) return table_of(data);
  Json copy = data;
  for (Json& part : copy) part = packed(part);
  return copy;
}

Json unpacked(Json data) {
  if (!data.is_structured()) return data;
  if (!is_table(data)) {
    for (Json& part : data) part = unpacked(std::move(part));
    return data;
  }
  Json list = Json::array();
  for (Json& row : data[rows]) {
    Json entry = Json::object();
    for (std::size_t i = 0; i < row.size(); ++i) {
      entry.push_back({data[columns][i].get<std::string>(), unpacked(std::move(row[i]))});
    }
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace ricochet::report
