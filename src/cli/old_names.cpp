#include "src/cli/old_names.h"

#include <fmt/format.h>

#include <map>

#include "ricochet/error.h"

namespace ricochet::cli {

std::string renaming_of(const std::string& word) {
  static const std::map<std::string, std::string> names = {
      {"--all-readings", "--all-interpretations"},
      {"--feature", "--perturbation"},
      {"--features", "--perturbations"},
      {"--form", "--formulation"},
      {"--forms", "--formulations"},
      {"--question", "--problem"},
      {"--questions", "--problems"},
      {"--reading", "--interpretation"},
      {"--width", "--smoothing"},
      {"--widths", "--smoothings"},
      {"questions", "problems"},
      {"readings", "interpretations"},
  };
  const auto found = names.find(word.substr(0, word.find('=')));
  return found == names.end() ? "" : found->first + " is now called " + found->second;
}

void add_moved(CommandLine& line, const std::string& command, const std::string& now) {
  CLI::App* moved = line.add(command, "Is now: ricochet " + now);
  moved->group("");  // hidden
  moved->allow_extras();
  line.on_call(moved, [command, now]() -> int {
    throw InputError(fmt::format("{}: is now: ricochet {}", command, now));
  });
}

}  // namespace ricochet::cli
