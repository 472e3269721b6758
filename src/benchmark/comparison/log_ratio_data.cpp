#include "src/benchmark/comparison/log_ratio_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "src/benchmark/comparison/profile_data.h"
#include "src/benchmark/statistics/log_ratio_profile.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

Json log_ratios_of(const Campaign& campaign, const EntrySet& set) {
  const std::vector<const Entry*> best = cheapest_first(campaign, set);
  const Entry& a = *best[0];
  const Entry& b = *best[1];
  std::vector<double> costs_of_a;
  std::vector<double> costs_of_b;
  for (std::size_t q = 0; q < set.problems.size(); ++q) {
    costs_of_a.push_back(running_time(campaign, *a.results[q]));
    costs_of_b.push_back(running_time(campaign, *b.results[q]));
  }
  const std::array names{std::string("both solve it"), "only " + a.solver, "only " + b.solver,
                         std::string("neither does")};
  std::array<Json, 4> bars;
  for (Json& one : bars) one = Json::array();
  int ahead_a = 0;
  int ahead_b = 0;
  int place = 0;
  for (const LogRatio& bar : log_ratio_profile(costs_of_a, costs_of_b)) {
    ++place;
    const auto kind = static_cast<std::size_t>(bar.solved_by);
    bars[kind].push_back({{"place", place},
                          {"problem", campaign.problems()[set.problems[bar.problem]].name},
                          {"log2_ratio", bar.log2_ratio},
                          {"lower", std::min(bar.log2_ratio, 0.0)},
                          {"upper", std::max(bar.log2_ratio, 0.0)}});
    if (bar.solved_by == SolvedBy::neither) continue;
    if (bar.log2_ratio < 0) ++ahead_a;
    if (bar.log2_ratio > 0) ++ahead_b;
  }
  Json kinds = Json::array();
  for (std::size_t k = 0; k < bars.size(); ++k) {
    if (!bars[k].empty()) kinds.push_back({{"solved_by", names[k]}, {"bars", std::move(bars[k])}});
  }
  return {{"family", set.family},
          {"a", a.solver},
          {"b", b.solver},
          {"formulation_a", a.formulation},
          {"formulation_b", b.formulation},
          {"ahead_a", ahead_a},
          {"ahead_b", ahead_b},
          {"problems", set.problems.size()},
          {"title", fmt::format("{}: {} needs less than {} on {} of {} problems", set.family,
                                a.solver, b.solver, ahead_a, set.problems.size())},
          {"kinds", std::move(kinds)}};
}

}  // namespace

Json log_ratio_data(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  return of_solved(sets, [&](const EntrySet& set) { return log_ratios_of(campaign, set); });
}

}  // namespace ricochet::studies::comparison
