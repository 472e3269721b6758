#include "src/benchmark/export/best_so_far.h"

#include <cmath>

namespace ricochet::exports {

std::vector<comparison::Step> best_so_far(const comparison::Outcome& outcome) {
  std::vector<comparison::Step> rows{{1, 0, nothing_feasible}};
  for (const comparison::Step& step : outcome.steps) {
    if (!std::isfinite(step.optimality_gap) || step.optimality_gap >= rows.back().optimality_gap)
      continue;
    if (step.evaluations > rows.back().evaluations) {
      rows.push_back(step);
    } else {
      rows.back().seconds = step.seconds;
      rows.back().optimality_gap = step.optimality_gap;
    }
  }
  if (outcome.evaluations > rows.back().evaluations) {
    rows.push_back({outcome.evaluations, outcome.seconds, rows.back().optimality_gap});
  }
  return rows;
}

}  // namespace ricochet::exports
