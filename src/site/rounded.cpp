#include "src/site/rounded.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace ricochet::site {

report::Json rounded(const report::Json& number) {
  if (number.is_number_integer()) return number;
  if (!number.is_number() || !std::isfinite(number.get<double>())) return nullptr;
  return std::stod(fmt::format("{:.5g}", number.get<double>()));
}

}  // namespace ricochet::site
