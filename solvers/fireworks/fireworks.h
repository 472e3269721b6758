#pragma once

#include <string>
#include <vector>

#include "src/core/solver.h"

/// The fireworks algorithm that optimised the driver plate's speed: equations (23)-(30) of the
/// paper, which takes it from Tan & Zhu, Fireworks algorithm for optimization, ICSI 2010.
namespace ricochet {

/// What equation (24) gives where a firework's share of sparks is within its limits.
enum class ThirdBranch {
  rounded_share,  ///< round(S_i), as Tan & Zhu have it
  as_printed,     ///< round(a m), as the paper prints it: the fewest, whatever the share
};

/// The defaults are those of Tan & Zhu; the paper states none.
struct FireworksOptions {
  int fireworks = 5;         ///< N of (23), >= 1
  double sparks = 50;        ///< m of (23): what the fireworks share
  double fewest = 0.04;      ///< a of (24): no firework has fewer than round(a m) sparks
  double most = 0.8;         ///< b of (24): and none more than round(b m); a < b < 1
  double amplitude = 40;     ///< A_hat of (25), in the units of x, whatever the width of the box
  int gaussian_sparks = 5;   ///< of (27), in each generation
  double epsilon = 2.2e-16;  ///< of (23) and (25), in the units of the objective
  ThirdBranch third_branch = ThirdBranch::rounded_share;
};

/// The algorithm as the paper describes it: every coordinate of a spark moves by a draw of its own,
/// a Gaussian spark multiplies a random firework's coordinates by one draw, the best of fireworks
/// and sparks (the first of equals) lives on, and the others are drawn with replacement. The first
/// firework is the start, the others are uniform in the box. It never stops by itself. A value that
/// is not a number below 1e300 in size counts as the worst. Takes no constraints.
/// Throws std::invalid_argument for fewer than one firework or a negative amplitude.
Solver fireworks(std::string name, const FireworksOptions& options);

/// Equations (23) and (24): how many sparks each firework gets, given the objectives of all
/// fireworks. A value that is not usable counts as the worst usable one.
std::vector<int> spark_counts(const Vector& objectives, const FireworksOptions& options);

/// Equation (25): how far the sparks of each firework fly along each coordinate, in the units of x.
Vector amplitudes(const Vector& objectives, const FireworksOptions& options);

/// Equation (28), coordinate by coordinate, for what lies outside [lower, upper]:
/// lower + |x| mod (upper - lower).
Vector mapped(const Vector& x, const Vector& lower, const Vector& upper);

/// Equation (29), the numerators of (30): for every point (a column of n x k) the sum of its
/// Euclidean distances to all. All 1 where every distance is 0, for then (30) is 0 / 0.
std::vector<double> roulette_weights(const Matrix& points);

}  // namespace ricochet
