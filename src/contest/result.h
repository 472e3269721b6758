#pragma once

#include <map>
#include <optional>
#include <string>

#include "src/contest/outcomes.h"
#include "src/statistics/interval.h"

namespace ricochet::contest {

/// A share of runs with Wilson's interval, both in [0, 1].
struct SolvedShare {
  double share;
  Interval interval;
};

/// An estimate with its interval; infinite ends where too few runs reached it to say.
struct Estimate {
  double value;
  Interval interval;
};

/// What the runs of one standing say. Intervals are of 95 %.
struct Result {
  int runs = 0;
  int distinct = 0;                        ///< runs that differ: repeats are counted once
  SolvedShare found{}, handed_over{};      ///< solved by a point evaluated, by the one returned
  std::optional<Estimate> running_time;    ///< expected evaluations to solve; nothing: never
  std::optional<double> seconds_to_solve;  ///< expected processor time
  Estimate gap{};                          ///< median regret; infinite: nothing feasible found
  int failed = 0;                          ///< runs that ended in an exception
  std::map<std::string, int> exits;        ///< how often the solver gave which reason
};

/// `outcomes` of one standing; at least one.
Result result_of(const Outcomes& outcomes);

}  // namespace ricochet::contest
