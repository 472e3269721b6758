#include "src/contest/chosen.h"

#include "src/core/patterns.h"

namespace ricochet::contest {

std::vector<Question> chosen_questions(const std::vector<Question>& all,
                                       const std::string& patterns, const std::string& option) {
  std::vector<Question> chosen;
  std::vector<std::string> names;
  const std::vector<std::string> list = split_patterns(patterns);
  for (const Question& question : all) {
    if (!question.stated.best_known) continue;
    names.push_back(question.name());
    if (fits_any(question.name(), list)) chosen.push_back(question);
  }
  require_fit(list, names, option);
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
  require_fit(list, names, option);
  return chosen;
}

}  // namespace ricochet::contest
