#include "src/benchmark/analysis/judged_runs.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace ricochet::comparison {

void each_judged(const Store& store, const std::function<void(const JudgedRun&)>& use,
                 const std::function<void(const JudgedCell&)>& at_end) {
  std::map<std::string, const StoredProblem*> problems;
  for (const StoredProblem& problem : store.description().problems) {
    problems[problem.name] = &problem;
  }
  std::optional<Cell> cell;
  std::vector<Outcome> outcomes;
  const auto end_cell = [&] {
    outcomes.shrink_to_fit();  // a report keeps a million outcomes
    if (cell) at_end({*cell, *problems.at(cell->problem), std::move(outcomes)});
    outcomes.clear();
  };
  store.each([&](const StoredRun& run) {
    if (cell != run.key.cell) {
      end_cell();
      cell = run.key.cell;
    }
    const StoredProblem& problem = *problems.at(cell->problem);
    outcomes.push_back(outcome_of(run.record, problem.best_known, problem.tolerance));
    use({problem, run, outcomes.back()});
  });
  end_cell();
}

}  // namespace ricochet::comparison
