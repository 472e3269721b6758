#include "src/studies/contest/share_data.h"

#include <algorithm>

#include "src/statistics/wilson_interval.h"

namespace ricochet::studies::contest {

report::Json share_data(const Share& share) {
  const Interval interval = wilson_interval(share.successes, share.trials);
  return {{"share", share.successes / static_cast<double>(share.trials)},
          {"lower", interval.lower},
          {"upper", interval.upper}};
}

std::map<std::string, std::map<std::string, Share>> shares_by_form(
    const ContestPlan& plan, const std::vector<Standing>& standings, const Group& group) {
  std::map<std::string, std::map<std::string, Share>> shares;
  const auto& mine = group.questions;
  for (const Standing& s : standings) {
    if (s.budget + 1 != plan.budgets.size()) continue;
    if (std::find(mine.begin(), mine.end(), s.question) == mine.end()) continue;
    add_runs(shares[s.solver][plan.questions[s.question].name_of(s.form)], s);
  }
  return shares;
}

void add_runs(Share& share, const Standing& standing) {
  for (const Outcome& outcome : standing.outcomes) {
    ++share.trials;
    share.successes += outcome.verdict.solved ? 1 : 0;
  }
}

}  // namespace ricochet::studies::contest
