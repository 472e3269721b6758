#include "src/studies/contest/log_ratio_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "src/statistics/log_ratio_profile.h"
#include "src/studies/contest/profile_data.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

Json log_ratios_of(const Campaign& campaign, const Field& field) {
  const std::vector<const Entrant*> best = cheapest_first(campaign, field);
  const Entrant& a = *best[0];
  const Entrant& b = *best[1];
  std::vector<double> costs_of_a;
  std::vector<double> costs_of_b;
  for (std::size_t q = 0; q < field.questions.size(); ++q) {
    costs_of_a.push_back(running_time(campaign, *a.standings[q]));
    costs_of_b.push_back(running_time(campaign, *b.standings[q]));
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
                          {"question", campaign.questions()[field.questions[bar.question]].name()},
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
  return {{"family", field.family},
          {"a", a.solver},
          {"b", b.solver},
          {"form_a", a.form},
          {"form_b", b.form},
          {"ahead_a", ahead_a},
          {"ahead_b", ahead_b},
          {"questions", field.questions.size()},
          {"title", fmt::format("{}: {} needs less than {} on {} of {} questions", field.family,
                                a.solver, b.solver, ahead_a, field.questions.size())},
          {"kinds", std::move(kinds)}};
}

}  // namespace

Json log_ratio_data(const Campaign& campaign, const std::vector<Field>& fields) {
  return of_compared(fields, [&](const Field& field) { return log_ratios_of(campaign, field); });
}

}  // namespace ricochet::studies::contest
