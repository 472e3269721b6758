#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "problems/classic/formula.h"
#include "ricochet/problem.h"

/// Problems from the literature with known optima: results are comparable with published ones.
namespace ricochet::classic {

/// Test functions, "classic-...", and test problems of Hock and Schittkowski, "hs-...".
std::vector<Problem> classic_problems();

/// One function of the least-squares benchmark, without its residuals.
struct Benchmark {
  std::string name;
  std::string origin;  ///< source of the function
  Vector start;        ///< the standard one
  double best_sum;     ///< the least sum of squares, twice the least objective
  Vector best_point;
  std::string provenance;
  bool rotates = true;
  Vector lower = {}, upper = {};  ///< the box; empty for the wide default of least_squares.h
};

/// The statement of the benchmark with `residuals` residuals, from `scale` times the start.
Statement statement_of(const Benchmark& benchmark, Eigen::Index residuals, double scale);

/// The problem of a formula for the residuals.
template <class Formula>
Problem least_squares(const Benchmark& benchmark, double scale, const Formula& formula) {
  const Eigen::Index residuals = detail::values_of(formula, benchmark.start).size();
  return from_residuals(statement_of(benchmark, residuals, scale), formula);
}

/// The origin of a function numbered in the collection of More, Garbow and Hillstrom.
std::string more_garbow_hillstrom(int number);

/// The origin of the other functions.
inline constexpr const char* cuter = "CUTEr (2003), doi 10.1145/962437.962439";

inline constexpr const char* all_zero = "closed form: every residual is 0 there";
inline constexpr const char* published =
    "published (More, Garbow and Hillstrom; optimagic, benchmarking/more_wild.py); "
    "digits by Newton's method";

/// The problem with its tolerance, penalty weight and cost of a gradient.
Problem with_tolerance(Problem problem);

/// Test functions, constrained test problems, and least squares.
std::vector<Family> families();

/// Bowls with a defect that occurs in practice: no number or no end in a part of the box, no
/// feasible point, an exception, a crash. They show what solvers do then.
Family pathological_family();

}  // namespace ricochet::classic
