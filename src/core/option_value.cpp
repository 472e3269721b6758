#include "src/core/option_value.h"

#include <fmt/format.h>

namespace ricochet {

std::string text_of(const OptionValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{}", *number) : std::get<std::string>(value);
}

}  // namespace ricochet
