#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/run.h"
#include "src/report/json.h"
#include "src/report/site/study.h"

namespace ricochet::studies::fireworks {

/// Returns one of the nine functions on which the algorithm was published, by its name in Table 3,
/// on [-100, 100]^n; its best value is 0. Schwefel is sum (x_1 - x_i^2)^2 + (x_i - 1)^2; Ellipse,
/// Cigar and Tablet have the factor 10^4. Throws std::out_of_range for another name.
Problem benchmark_function(const std::string& name, Eigen::Index n);

/// Sum (x_i - shift)^2 on [-100, 100]^n.
Problem shifted_sphere(double shift, Eigen::Index n);

/// Error of every member of the family on Sphere, in 30 dimensions with 10,000 evaluations, over
/// the distance of the optimum from the origin.
report::Json shift_data(int runs);

/// Function 1 to 28 of the competition on real-parameter optimisation at CEC 2013, on [-100,
/// 100]^n, minus its best value, so that the minimum is 0; n is 2, 5, 10, 20, ..., 100. The code is
/// pagmo's, which is not thread-safe: one problem per thread. Throws std::invalid_argument for
/// another number or n.
Problem cec2013(unsigned number, unsigned n);

/// Tan and Zhu's program, the corrected one, EFWA, dynFWA, BBFWA, LoTFWA, MGFWA and FWASSP on six
/// functions of the competition of CEC 2013, in 30 dimensions, with the results of other
/// implementations. No rows in a build without pagmo.
report::Json competition_data(int runs, std::int64_t evaluations);

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
RICOCHET_FIELDS(Moments, mean, deviation, runs, lower, upper);

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

/// Needle in a haystack: on [0, 1000] a target of width 1 that begins at `target`: 0 inside it and
/// 1 elsewhere.
Problem needle(double target);

/// The same target, with ceil(log2(1 + distance)) elsewhere: a staircase that leads to it.
Problem logarithmic_staircase(double target);

/// How often each member of the family, and random search, hits such a target within 1000
/// evaluations.
report::Json plateau_data(int runs);

/// Published results of others, from published.json, by the name of the comparison; each with its
/// `source`.
const report::Json& published();

/// The functions of Tan and Zhu's Table 3 in 30 dimensions with 10,000 evaluations, from their
/// start, with the interpretations of the algorithm; compared with their published results.
report::Json table_3_data(int runs);

}  // namespace ricochet::studies::fireworks

namespace ricochet::studies {

/// Compares the fireworks family with published measurements: ten minutes of processor time.
Study fireworks_study();

}  // namespace ricochet::studies
