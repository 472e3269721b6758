#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/run.h"
#include "src/report/results.h"
#include "src/report/site/study.h"

namespace ricochet::studies {

/// Compares the fireworks family with published results: five minutes of processor time.
Study fireworks_study();

}  // namespace ricochet::studies

namespace ricochet::studies::fireworks {

/// Returns one of the nine functions on which the algorithm was published, by its name in Table 3,
/// on [-100, 100]^n; its best value is 0. Schwefel is sum (x_1 - x_i^2)^2 + (x_i - 1)^2; Ellipse,
/// Cigar and Tablet have the factor 10^4. Throws std::out_of_range for another name.
Problem benchmark_function(const std::string& name, Eigen::Index n);

/// Sum (x_i - shift)^2 on [-100, 100]^n.
Problem shifted_sphere(double shift, Eigen::Index n);

/// Function 1 to 28 of the competition on real-parameter optimisation at CEC 2013, on [-100,
/// 100]^n, minus its best value, so that the minimum is 0; n is 2, 5, 10, 20, ..., 100. The code is
/// pagmo's, which is not thread-safe: one problem per thread. Throws std::invalid_argument for
/// another number or n.
Problem cec2013(unsigned number, unsigned n);

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

/// Mean, standard deviation and number of values.
struct Moments {
  double mean, deviation;
  std::size_t runs;
};

/// Of at least two values.
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

struct ComparisonPlan {
  int runs;              ///< on the functions of 2010, and on the shifted sphere; at least two
  int competition_runs;  ///< on the functions of CEC 2013; at least two
  std::int64_t competition_evaluations;
};

/// The family beside published.json, in 30 dimensions:
/// - the algorithm of 2010, in three interpretations, on the functions of Tan and Zhu's Table 3;
/// - EFWA, dynFWA, BBFWA and LoTFWA on six functions of the competition of CEC 2013 (left out in a
///   build without pagmo);
/// - every member on Sphere, over the distance of the optimum from the origin.
/// Tables: variants (a row for each member), results (a row for each published mean) and shift; the
/// chart shift; and the values that the page names.
report::Results compared_with_published(const ComparisonPlan& plan);

}  // namespace ricochet::studies::fireworks
