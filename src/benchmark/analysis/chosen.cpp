#include "src/benchmark/analysis/chosen.h"

#include "src/core/patterns.h"

namespace ricochet::comparison {

std::vector<Problem> chosen_problems(const std::vector<Problem>& all, const std::string& patterns,
                                     const std::string& option) {
  std::vector<Problem> chosen;
  std::vector<std::string> names;
  const std::vector<std::string> list = split_patterns(patterns);
  for (const Problem& problem : all) {
    if (!problem.best_known) continue;
    names.push_back(problem.name);
    if (fits_any(problem.name, list)) chosen.push_back(problem);
  }
  require_fit(list, names, option, "`ricochet list problems`");
  return chosen;
}

std::vector<Solver> chosen_solvers(const std::vector<Solver>& all, const std::string& patterns,
                                   const std::string& option) {
  std::vector<Solver> chosen;
  std::vector<std::string> names;
  const std::vector<std::string> list = split_patterns(patterns);
  for (const Solver& solver : all) {
    names.push_back(solver.name);
    if (fits_any(solver.name, list)) chosen.push_back(solver);
  }
  require_fit(list, names, option, "`ricochet list solvers`");
  return chosen;
}

}  // namespace ricochet::comparison
