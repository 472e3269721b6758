#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/benchmark/analysis/outcomes.h"
#include "src/benchmark/statistics/interval.h"

namespace ricochet::comparison {

/// A share of runs with Wilson's interval, both in [0, 1].
struct SolvedShare {
  double share;
  Interval interval;
};

/// An estimate with its interval; an end is infinite if too few runs reached the target.
struct Estimate {
  double value;
  Interval interval;
};

/// A summary of the runs of one cell. Intervals are of 95 %.
struct Result {
  int runs = 0;
  int distinct = 0;                 ///< number of different runs: repeats are counted once
  SolvedShare found{}, returned{};  ///< solved by an evaluated point, by the returned point
  /// ERT [evaluations] of the problem's tolerance, by the best evaluated and by the returned point;
  /// nothing if no run solved it.
  std::optional<Estimate> running_time, returned_running_time;
  std::optional<double> seconds_to_solve;  ///< expected processor time, by the returned point
  Estimate gap{};  ///< median optimality gap of the returned points; infinite: none is feasible
  int failed = 0;  ///< runs that ended in an exception
  std::map<std::string, int> terminations;  ///< number of starts by termination reason
};

/// For each run of a cell, whether it repeats an earlier one: as many evaluations, the same
/// improvements at the same evaluations, and a returned point of the same value. Then the solver
/// draws no random numbers, or the instances look alike to it.
std::vector<bool> repeats(const Outcomes& outcomes);

/// The summary of `outcomes` of one cell; there must be at least one.
Result result_of(const Outcomes& outcomes);

}  // namespace ricochet::comparison
