#include "src/export/best_so_far.h"

#include <cmath>

namespace ricochet::exports {

std::vector<contest::Step> best_so_far(const contest::Outcome& outcome) {
  std::vector<contest::Step> rows{{1, 0, nothing_feasible}};
  for (const contest::Step& step : outcome.steps) {
    if (!std::isfinite(step.regret) || step.regret >= rows.back().regret) continue;
    if (step.evaluations > rows.back().evaluations) {
      rows.push_back(step);
    } else {
      rows.back().seconds = step.seconds;
      rows.back().regret = step.regret;
    }
  }
  if (outcome.evaluations > rows.back().evaluations) {
    rows.push_back({outcome.evaluations, outcome.seconds, rows.back().regret});
  }
  return rows;
}

}  // namespace ricochet::exports
