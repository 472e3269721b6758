#pragma once

#include <map>
#include <string>
#include <variant>

namespace ricochet {

/// The value of a solver's option: a number or a word.
using OptionValue = std::variant<double, std::string>;

/// By name.
using GivenOptions = std::map<std::string, OptionValue>;

std::string text_of(const OptionValue& value);

}  // namespace ricochet
