#include "src/benchmark/comparison/leader_data.h"

#include <limits>
#include <map>
#include <utility>

#include "src/benchmark/analysis/result.h"
#include "src/benchmark/statistics/bootstrap.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

constexpr double easy_for_random_search = 20;  // evaluations

/// Expected running time of random search, on the true values, the median over the problems.
Json random_search_time(const Comparison& comparison, const Group& group) {
  std::map<std::size_t, double> times;
  for (const CellResult& result : comparison.results) {
    const PlannedCell& cell = *result.cell;
    const bool largest = cell.cell.budget == comparison.part->budgets.back();
    if (cell.cell.solver != "random-search" || !largest || cell.formulation.smoothing > 0 ||
        !group.has(result)) {
      continue;
    }
    const auto time = result_of(result.outcomes).returned_running_time;
    const double value = time ? time->value : std::numeric_limits<double>::infinity();
    const auto [known, fresh] = times.try_emplace(cell.problem, value);
    known->second = std::min(known->second, value);
  }
  std::vector<double> all;
  for (const auto& [problem, time] : times) all.push_back(time);
  return all.empty() ? Json() : report::as_json(quantile(std::move(all), 0.5));
}

}  // namespace

Json leader_data(const Comparison& comparison, const std::vector<Group>& groups, const Json& rows) {
  Json leaders = Json::array();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Json random = random_search_time(comparison, groups[g]);
    const bool easy = random.is_number() && random.get<double>() <= easy_for_random_search;
    for (const Json& budget : rows[g]["budgets"]) {
      Json row = budget["leader"];
      if (easy) {
        const Json of = row["of"];
        const Json single = row["single"];
        for (auto& [key, value] : row.items()) value = nullptr;
        row.update({{"differs", false}, {"of", of}, {"single", single}});
      }
      row["family"] = rows[g]["family"];
      row["budget"] = budget["budget"];
      row["largest"] = budget == rows[g]["budgets"].back();
      row["random"] = random;
      row["easy"] = easy;
      leaders.push_back(std::move(row));
    }
  }
  return leaders;
}

}  // namespace ricochet::studies::comparison
