#include "src/cli/hints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string_view>
#include <vector>

#include "src/core/near_names.h"

namespace ricochet::cli {
namespace {

bool is_number(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.starts_with("FLOAT") || type.starts_with("INT") || type.starts_with("UINT");
}

/// What follows the number at the beginning of a text; the whole text if there is none.
std::string_view after_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  std::string_view rest(end);
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  return rest;
}

std::string hint_at_number(const CLI::Option& option, const std::string& value) {
  const std::string_view unit = after_number(value);
  if (unit.empty()) return "";
  std::string hint = fmt::format("{} {}: must be a number", option.get_name(), value);
  if (unit.size() == value.size()) return hint;
  hint += ", without a unit";
  const bool in_radians = option.get_description().find("rad/s") != std::string::npos;
  if (!in_radians) return hint;
  hint += ", in rad/s";
  constexpr double of_a_minute = 2 * std::numbers::pi / 60;
  if (unit == "rpm" || unit == "1/min") {
    hint += fmt::format(": {:.6g}", std::strtod(value.c_str(), nullptr) * of_a_minute);
  }
  return hint;
}

}  // namespace

std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t start = type.find('{');
  if (start == std::string::npos) return {};
  return CLI::detail::split(type.substr(start + 1, type.find('}') - start - 1), ',');
}

std::string hint_at_argument(const CLI::App& command, const std::string& argument) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() || option->get_lnames().empty()) continue;
    const std::vector<std::string> choices = choices_of(*option);
    const auto choice = std::ranges::find_if(
        choices, [&](const std::string& each) { return equal_in_any_case(each, argument); });
    if (choice != choices.end()) {
      return fmt::format("{0}: give it as {1} {2}", argument, option->get_name(), *choice);
    }
  }
  std::error_code none;
  const bool is_machine = std::filesystem::path(argument).extension() == ".toml" ||
                          std::filesystem::exists(argument, none);
  if (is_machine && command.get_option_no_throw("--scene") != nullptr) {
    return fmt::format("{0}: give it as --scene {0}", argument);
  }
  return "";
}

std::string hint_at_value(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string> choices = choices_of(*option);
    const std::string type = option->get_type_name();
    const bool is_closed = !choices.empty() && type.find(":FILE") == std::string::npos &&
                           !type.starts_with("PLAN") && !type.starts_with("SOLVER");
    for (const std::string& value : option->results()) {
      if (is_closed && std::ranges::find(choices, value) == choices.end()) {
        const std::string name = option->get_positional() ? "" : option->get_name() + " ";
        return fmt::format("{}{}: {}", name, value, what_instead(value, choices));
      }
      const std::string hint = is_number(*option) ? hint_at_number(*option, value) : "";
      if (!hint.empty()) return hint;
    }
  }
  return "";
}

std::string hint_at_call(const CLI::App& command, const std::string& path) {
  const std::string examples = command.get_footer();
  std::size_t start = examples.find("  " + path + " ");
  if (start == std::string::npos) return "";
  start += 2;
  return "as in: " + examples.substr(start, examples.find('\n', start) - start);
}

}  // namespace ricochet::cli
