#include "src/export/judged_runs.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace ricochet::exports {

void each_judged(const Store& store, const std::function<void(const JudgedRun&)>& use,
                 const std::function<void(const JudgedCell&)>& at_end) {
  std::map<std::string, const StoredQuestion*> questions;
  for (const StoredQuestion& question : store.description().questions) {
    questions[question.name] = &question;
  }
  std::optional<Cell> cell;
  std::vector<contest::Outcome> outcomes;
  const auto end_cell = [&] {
    if (cell) at_end({*cell, *questions.at(cell->question), std::move(outcomes)});
    outcomes.clear();
  };
  store.each([&](const StoredRun& run) {
    if (cell != run.key.cell) {
      end_cell();
      cell = run.key.cell;
    }
    const StoredQuestion& question = *questions.at(cell->question);
    outcomes.push_back(contest::outcome_of(run.record, question.best_known, question.tolerance));
    use({question, run, outcomes.back()});
  });
  end_cell();
}

}  // namespace ricochet::exports
