#pragma once

#include <cstddef>
#include <vector>

#include "problems/carrier_track/identification/knock_loss.h"
#include "ricochet/random.h"
#include "ricochet/solver.h"

namespace ricochet::studies::identification {

/// The unknowns that explain recorded knocks best.
struct KnockFit {
  Vector x;           ///< see KnockUnknowns
  Matrix covariance;  ///< of x; zero for coordinates that are not fitted
  double loss;
  double excess;         ///< how far the loss could still fall, by its gradient
  int evaluations;       ///< simulations of the record
  bool complete = true;  ///< otherwise the time limit was reached, and the covariance is zero
};

/// Searches from several starts, at most `starts`, until the same minimum has been found twice.
/// The solver must take gradients. Throws what a simulation throws; TimeLimitReached only if no
/// start has been followed to its end.
KnockFit fit_knocks(const carrier_track::KnockLoss& loss, const Solver& solver,
                    std::size_t starts = 8);

/// Improves x without a search from elsewhere, such as after a change of the loss. Returns the
/// loss.
double refine(const carrier_track::KnockLoss& loss, const Solver& solver, Vector& x);

/// Points from which to fit, the most promising first, at most `most`: constants drawn around the
/// scene's, each with the plate's angle and speed that suit the record best. The first draw is the
/// scene itself.
std::vector<Vector> fit_starts(const carrier_track::KnockLoss& loss, std::size_t most,
                               Random& random);

}  // namespace ricochet::studies::identification
