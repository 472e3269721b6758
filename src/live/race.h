#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ricochet/scene.h"

/// Solvers that look for the fastest quiet speed of a machine, evaluation by evaluation.
namespace ricochet::live {

/// Who takes part.
enum class Racer {
  fireworks,      ///< the paper's equations
  random_search,  ///< uniform points
  bisection       ///< halves the interval between quiet and loud
};

/// What all of them look for: the fastest speed whose collision count is quiet.
struct Race {
  carrier_track::Scene machine;  ///< valid; its speed is not used
  double quiet_limit = 0;        ///< a count up to this is quiet
  double fastest = 18;           ///< [rad/s], end of the range
  std::int64_t evaluations = 100;
};

/// One evaluation.
struct RaceStep {
  double omega;  ///< [rad/s]
  int count;     ///< collisions there
  double value;  ///< [rad/s], which the solver minimises: -omega, plus the penalty where it has one
};

/// The evaluations of one solver, in their order. The problem is top-speed of the suite; bisection
/// has the count as a constraint, the others as a penalty. A solver that has converged begins again
/// elsewhere, as in the suite's runs. The same seed gives the same steps.
std::vector<RaceStep> steps_of(Racer racer, const Race& race, std::uint64_t seed);

/// The solution [rad/s] of the race, which no solver has a part in: the fastest quiet multiple of
/// the step, moved to the border between it and the next one by bisection, to 1e-9 rad/s; the end
/// of the range if that is quiet. Nothing if none is quiet. `step` [rad/s] > 0.
std::optional<double> goal_of(const Race& race, double step = 1e-3);

}  // namespace ricochet::live
