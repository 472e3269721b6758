#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "ricochet/random.h"
#include "src/analysis/statistics/intervals.h"

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

/// exp(mean of log(max(x, floor) + shift)) - shift: a mean of costs in which neither a few long
/// runs nor differences between very short ones have much weight (Achterberg 2007, Constraint
/// Integer Programming, section A.3; shift and floor of PAVER 2.0, doi:10.1007/s10898-013-0131-5,
/// for seconds). Infinite if a cost is; therefore charge a failed run what it spent. Throws
/// std::invalid_argument for no costs, a cost that is negative or no number, or unless shift >= 0
/// and floor >= 0 are finite and not both 0.
double shifted_geometric_mean(const std::vector<double>& costs, double shift = 10,
                              double floor = 1);

/// The cost (evaluations or seconds, > 0) of every solver to solve a problem: a row for each
/// problem, an entry for each solver. Infinite if the solver did not solve it.
using Costs = std::vector<std::vector<double>>;

/// Returns the number of solvers. Throws std::invalid_argument if there is no problem or no solver,
/// rows differ in length, or a cost is not positive.
std::size_t check_costs(const Costs& costs);

}  // namespace ricochet
