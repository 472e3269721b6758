#include "src/benchmark/comparison/share_data.h"

#include <fmt/format.h>

#include <algorithm>

#include "src/benchmark/statistics/wilson_interval.h"

namespace ricochet::studies::comparison {

using report::Json;

Json share_data(const Share& share) {
  const Interval interval = wilson_interval(share.successes, share.trials);
  return {{"share", share.successes / static_cast<double>(share.trials)},
          {"lower", interval.lower},
          {"upper", interval.upper}};
}

std::map<std::string, std::map<std::string, Share>> shares_by_formulation(
    const Comparison& comparison, const Group& group) {
  std::map<std::string, std::map<std::string, Share>> shares;
  for (const CellResult& result : comparison.results) {
    const Cell& cell = result.cell->cell;
    if (cell.budget != comparison.part->budgets.back() || !group.has(result)) continue;
    add_runs(shares[cell.solver][cell.formulation], result);
  }
  return shares;
}

void add_runs(Share& share, const CellResult& result) {
  for (const Outcome& outcome : result.outcomes) {
    ++share.trials;
    share.successes += outcome.solved() ? 1 : 0;
  }
}

Json variables_of(const Campaign& campaign, const std::vector<std::size_t>& problems) {
  Eigen::Index least = campaign.problems()[problems.front()].dimension();
  Eigen::Index most = least;
  for (const std::size_t q : problems) {
    const Eigen::Index n = campaign.problems()[q].dimension();
    least = std::min(least, n);
    most = std::max(most, n);
  }
  return {
      {"variables", least == most ? std::to_string(least) : fmt::format("{} to {}", least, most)},
      {"several", most > 1}};
}

}  // namespace ricochet::studies::comparison
