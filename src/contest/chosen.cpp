#include "src/contest/chosen.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <sstream>

#include "src/core/error.h"
#include "src/core/near_names.h"

namespace ricochet::contest {
namespace {

/// Throws what is said where no name fits.
[[noreturn]] void refuse(const std::string& option, const std::string& patterns,
                         const std::vector<std::string>& names) {
  throw InputError(
      fmt::format("{} {}: nothing fits; {}", option, patterns, what_instead(patterns, names)));
}

}  // namespace

bool fits(const std::string& name, const std::string& patterns) {
  std::istringstream list(patterns);
  for (std::string pattern; std::getline(list, pattern, ',');) {
    if (fnmatch(pattern.c_str(), name.c_str(), 0) == 0) return true;
  }
  return false;
}

std::vector<Question> chosen_questions(const std::vector<Question>& all,
                                       const std::string& patterns, const std::string& option) {
  std::vector<Question> chosen;
  std::vector<std::string> names;
  for (const Question& question : all) {
    if (!question.stated.best_known) continue;
    names.push_back(question.name());
    if (fits(question.name(), patterns)) chosen.push_back(question);
  }
  if (chosen.empty()) refuse(option, patterns, names);
  return chosen;
}

std::vector<Solver> chosen_solvers(const std::vector<Solver>& all, const std::string& patterns,
                                   const std::string& option) {
  std::vector<Solver> chosen;
  std::vector<std::string> names;
  for (const Solver& solver : all) {
    names.push_back(solver.name);
    if (fits(solver.name, patterns)) chosen.push_back(solver);
  }
  if (chosen.empty()) refuse(option, patterns, names);
  return chosen;
}

}  // namespace ricochet::contest
