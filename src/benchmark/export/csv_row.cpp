#include "src/benchmark/export/csv_row.h"

#include <fmt/format.h>

#include "src/core/csv_field.h"

namespace ricochet::exports {

std::string csv_row(const std::vector<std::string>& fields) {
  std::string row;
  for (const std::string& field : fields) {
    if (&field != &fields.front()) row += ',';
    row += csv_field(field);
  }
  return row + '\n';
}

std::string number(double value) {
  return fmt::format("{}", value);
}

std::string number(const std::optional<double>& value) {
  return value ? number(*value) : "";
}

}  // namespace ricochet::exports
