#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/core/run.h"
#include "src/report/json.h"

namespace ricochet::studies::fireworks {

/// One solver on one problem, so many times.
struct Contestant {
  Solver solver;
  /// Makes the problem for one run, whose thread alone uses it.
  std::function<Problem()> problem;
};

/// What each of the contestants is away from the best value, 0, at the end of each run, numbered
/// from 1. In parallel; the same on any number of threads.
std::vector<std::vector<double>> errors_of(const std::vector<Contestant>& contestants,
                                           std::int64_t evaluations, int runs,
                                           const std::string& progress);

/// Mean, standard deviation and number of the values, at least two, with an interval of 95 % for
/// the mean, as if they were normal (Student's t).
report::Json moments_of(const std::vector<double>& values);

/// Another's figure.
struct OtherMean {
  double mean;
  int runs;
  std::optional<double> deviation = {};  ///< without one, the same as ours
};

/// Whether it agrees with these moments: not further away than chance would bring it in 1 of 20
/// cases (Welch's t, with our degrees of freedom), or than 1e-8, below which the competitions of
/// CEC take an error for zero.
bool agrees(const report::Json& moments, const OtherMean& other);

}  // namespace ricochet::studies::fireworks
