#include "src/studies/contest/failure_data.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

namespace ricochet::studies::contest {

using report::Json;

Json failure_data(const ContestPlan& plan, const std::vector<Standing>& standings) {
  Json rows = Json::array();
  for (const Standing& standing : standings) {
    const Question& question = plan.questions[standing.question];
    // How often, and on which instance first.
    std::map<std::string, std::pair<int, int>> failures;
    for (const auto& outcome : standing.outcomes) {
      if (outcome.failure.empty()) continue;
      ++failures.try_emplace(outcome.failure, 0, outcome.instance).first->second.first;
    }
    const std::string form = question.name_of(standing.form);
    const std::int64_t budget = plan.budgets[standing.budget] * question.stated.dimension();
    for (const auto& [what, times] : failures) {
      rows.push_back({{"solver", standing.solver},
                      {"question", question.name()},
                      {"form", form},
                      {"what", what},
                      {"times", times.first},
                      {"runs", standing.outcomes.size()},
                      {"command", fmt::format("ricochet solve '{}' {} --form {} --budget {} "
                                              "--instance {} --seed {}",
                                              standing.solver, question.name(), form, budget,
                                              times.second, plan.run)}});
    }
  }
  return rows;
}

}  // namespace ricochet::studies::contest
