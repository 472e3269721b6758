#include "src/benchmark/comparison/sample_data.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "src/benchmark/analysis/stratified_sample.h"
#include "src/benchmark/comparison/group.h"
#include "src/benchmark/comparison/order.h"
#include "src/benchmark/comparison/share_data.h"
#include "src/core/seed.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// The share of a problem's runs, over all entries, that did not solve it.
double difficulty_of(const Comparison& comparison, std::size_t problem) {
  Share solved{};
  for (const CellResult& result : comparison.results) {
    if (result.cell->problem == problem) add_runs(solved, result);
  }
  return 1 - static_cast<double>(solved.successes) / solved.trials;
}

Json family_row(const Comparison& comparison, const Group& group, std::size_t number) {
  std::vector<double> difficulties;
  for (const std::size_t problem : group.problems) {
    difficulties.push_back(difficulty_of(comparison, problem));
  }
  std::vector<std::size_t> drawn;
  Json problems = Json::array();
  for (const std::size_t k :
       stratified_sample(difficulties, number, seed_of("sample", group.family, 0, 0))) {
    drawn.push_back(group.problems[k]);
    problems.push_back({{"problem", comparison.campaign->problems()[group.problems[k]].name},
                        {"difficulty", difficulties[k]}});
  }
  const std::size_t budget = comparison.part->budgets.size() - 1;
  const std::vector<Rating> ratings = rate(comparison, group.problems, budget);
  const Order whole = order_of(ratings);
  const Rating* leader = leader_of(ratings);
  const Order sample = order_of(rate(comparison, drawn, budget));
  return {{"family", group.family},
          {"of", group.problems.size()},
          {"problems", std::move(problems)},
          {"agreement", agreement_of(whole, sample)},
          {"leader", whole.leader},
          {"returned", leader != nullptr ? Json(leader->returned) : Json()},
          {"best", leader != nullptr ? Json(leader->probability_of_being_best) : Json()},
          {"sample_leader", sample.leader}};
}

}  // namespace

Json sample_data(const Campaign& campaign, const std::vector<CellResult>& results, double share,
                 std::size_t least) {
  Json rows = Json::array();
  for (const ReportedPart& part : reported_parts(campaign)) {
    const Comparison comparison = comparison_of(campaign, results, part.usual);
    for (Group group : groups_of(comparison)) {
      const auto part_of_all = std::llround(share * static_cast<double>(group.problems.size()));
      group.family = part.families.at(group.family);
      rows.push_back(
          family_row(comparison, group, std::max(least, static_cast<std::size_t>(part_of_all))));
    }
  }
  return rows;
}

}  // namespace ricochet::studies::comparison
