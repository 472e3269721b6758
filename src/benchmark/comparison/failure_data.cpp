#include "src/benchmark/comparison/failure_data.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

namespace ricochet::studies::comparison {

using report::Json;

Json failure_data(const ricochet::comparison::Comparison& comparison) {
  Json rows = Json::array();
  for (const auto& result : comparison.results) {
    const Cell& cell = result.cell->cell;
    // The number of failures, and the first instance with one.
    std::map<std::string, std::pair<int, int>> failures;
    for (const auto& outcome : result.outcomes) {
      if (outcome.failure.empty()) continue;
      ++failures.try_emplace(outcome.failure, 0, outcome.instance).first->second.first;
    }
    for (const auto& [what, times] : failures) {
      rows.push_back({{"solver", cell.solver},
                      {"problem", cell.problem},
                      {"formulation", cell.formulation},
                      {"what", what},
                      {"times", times.first},
                      {"runs", result.outcomes.size()},
                      {"command", fmt::format("ricochet solve '{}' {} --formulation {} --budget {} "
                                              "--instance {} --seed {}",
                                              cell.solver, cell.problem, cell.formulation,
                                              result.cell->budget.evaluations, times.second,
                                              comparison.run)}});
    }
  }
  return rows;
}

}  // namespace ricochet::studies::comparison
