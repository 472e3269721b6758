#pragma once

#include <optional>
#include <vector>

#include "src/benchmark/statistics/interval.h"

namespace ricochet {

/// The effort of a run until it reached the target, or in all if it did not.
struct Effort {
  double spent;  ///< evaluations or seconds, >= 0
  bool reached;
};

/// Expected effort to reach the target with independent restarts (ERT): the effort of all runs,
/// each failed one with its full length, over the number of successes (Hansen et al. 2021,
/// doi:10.1080/10556788.2020.1808977). Nothing if no run reached it.
std::optional<double> expected_running_time(const std::vector<Effort>& runs);

/// Interval of the expected running time from at least one run: the mean effort of a run, on a
/// logarithmic scale and with Student's t, over the share of successes, with Wilson's interval.
/// They are combined as Zou (2007, doi:10.1037/1082-989X.12.4.399) does for correlated estimates.
/// For runs that are independent and identically distributed except for their budgets. If no run
/// succeeded, the upper end is infinite, and the lower one is the mean effort over the largest
/// success probability that so many failures allow. A single run that succeeded gives [0,
/// infinity]. If all runs succeeded, the cost of a failure is unknown, and the upper end may be too
/// low: with 15 runs that succeed with probability 0.9, and otherwise spend ten times as much, the
/// coverage is 80 %. Throws std::invalid_argument for no runs or an effort that is negative,
/// infinite or no number.
Interval expected_running_time_interval(const std::vector<Effort>& runs, double confidence = 0.95);

}  // namespace ricochet
