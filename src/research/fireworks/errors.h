#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/run.h"
#include "src/report/json.h"

namespace ricochet::studies::fireworks {

/// One solver on one problem.
struct Entry {
  Solver solver;
  /// Creates the problem for one run; it is used on that run's thread only.
  std::function<Problem()> problem;
};

/// Returns the errors of each entry, i.e. distances from the best value, 0, at the end of each run,
/// numbered from 1. In parallel; independent of the number of threads.
std::vector<std::vector<double>> errors_of(const std::vector<Entry>& entries,
                                           std::int64_t evaluations, int runs,
                                           const std::string& progress);

/// Mean, standard deviation and number of values, with an interval of 95 % for the mean.
struct Moments {
  double mean, deviation;
  std::size_t runs;
  double lower, upper;
};
RICOCHET_JSON(Moments, mean, deviation, runs, lower, upper);

/// Of at least two values, assumed to be normal (Student's t).
Moments moments_of(const std::vector<double>& values);

/// A published mean.
struct OtherMean {
  double mean;
  int runs;
  std::optional<double> deviation = {};  ///< if missing: the same as ours
};

/// Returns true if it agrees with these moments: the difference is not significant at 5 % (Welch's
/// t, with our degrees of freedom), or below 1e-8, which the competitions of CEC count as zero.
bool agrees(const Moments& moments, const OtherMean& other);

}  // namespace ricochet::studies::fireworks
