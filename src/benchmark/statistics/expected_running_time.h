#pragma once

#include <optional>
#include <vector>

#include "src/statistics/interval.h"

namespace ricochet {

/// What a run spent until it reached the target, or in all if it did not.
struct Effort {
  double spent;  ///< evaluations or seconds, >= 0
  bool reached;
};

/// Expected effort to reach the target with independent restarts: the effort of all runs, each
/// failed one at its own length, over the number of successes (Hansen et al. 2021,
/// doi:10.1080/10556788.2020.1808977). Nothing where no run reached it.
std::optional<double> expected_running_time(const std::vector<Effort>& runs);

/// Interval of the expected running time from at least one run: the mean effort of a run, on a
/// logarithmic scale and with Student's t, over the share of successes, by Wilson's interval,
/// joined as Zou (2007, doi:10.1037/1082-989X.12.4.399) joins those of correlated estimates. For
/// runs that are independent and alike but for their budgets. Where no run succeeded it has no
/// upper end, and its lower one is the effort at the largest share that so many failures leave
/// possible; one success alone says nothing. Where all succeeded, what a failure would have cost is
/// unknown, and the upper end may be too low: of 15 runs that succeed nine times in ten, and else
/// spend ten times as much, it covers 80 %. Throws std::invalid_argument for no runs or an effort
/// that is negative, infinite or no number.
Interval expected_running_time_interval(const std::vector<Effort>& runs, double confidence = 0.95);

}  // namespace ricochet
