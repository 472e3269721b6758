#include "src/cli/old_names.h"

#include <map>

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

}  // namespace ricochet::cli
