#include "solvers/adjustable_solver.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace ricochet {

bool SolverOption::allows(const OptionValue& value) const {
  if (const auto* word = std::get_if<std::string>(&value)) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& known) { return known == "*" || known == *word; });
  }
  const double number = std::get<double>(value);
  return words.empty() && number >= least && number <= most &&
         (!whole || number == std::floor(number)) && !(without_least && number == least) &&
         !(without_most && number == most);
}

std::string SolverOption::range() const {
  if (!words.empty()) {
    const bool any = std::find(words.begin(), words.end(), "*") != words.end();
    return any ? "a text" : fmt::format("\"{}\"", fmt::join(words, "\", \""));
  }
  std::string range = fmt::format("a {}number from {} to {}", whole ? "whole " : "", least, most);
  if (without_least) range += fmt::format(", but not {}", least);
  if (without_most) range += fmt::format(", but not {}", most);
  return range;
}

SolverOption real_option(const std::string& name, double least, double most, double usual) {
  return {.name = name, .usual = fmt::format("{}", usual), .least = least, .most = most};
}

SolverOption whole_option(const std::string& name, int least, int usual) {
  return whole_option(name, least, fmt::format("{}", usual));
}

SolverOption whole_option(const std::string& name, int least, const std::string& usual) {
  return {.name = name,
          .usual = usual,
          .least = static_cast<double>(least),
          .most = 1e6,
          .whole = true};
}

double number_of(const GivenOptions& given, const std::string& name, double usual) {
  const auto found = given.find(name);
  return found == given.end() ? usual : std::get<double>(found->second);
}

int whole_of(const GivenOptions& given, const std::string& name, int usual) {
  return static_cast<int>(number_of(given, name, usual));
}

}  // namespace ricochet
