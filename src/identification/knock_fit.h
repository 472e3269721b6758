#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "problems/carrier_track/identification/knock_loss.h"
#include "ricochet/random.h"
#include "ricochet/solver.h"
#include "src/report/chart.h"

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
/// start has been followed to its end; InputError if none can be improved.
KnockFit fit_knocks(const carrier_track::KnockLoss& loss, const Solver& solver,
                    std::size_t starts = 8);

/// Improves x without a search from elsewhere, such as after a change of the loss. Returns the
/// loss.
double refine(const carrier_track::KnockLoss& loss, const Solver& solver, Vector& x);

/// Points from which to fit, the most promising first, at most `most`: constants drawn around the
/// scene's, each with the plate's angle and speed that suit the record best. The first draw is the
/// scene itself, as near as the limits of a search allow.
std::vector<Vector> fit_starts(const carrier_track::KnockLoss& loss, std::size_t most,
                               Random& random);

/// What the record contradicts at the fit, one sentence each, with by how much. Empty: the
/// intervals may be trusted. Tested are the residuals of times and logarithms of strengths by wall
/// and speed of the plate, the shares of spurious and missed knocks, and lag, clock and mark angle
/// against their prior knowledge: as fitted, and in a fit that does without it.
std::vector<std::string> contradictions(const carrier_track::KnockLoss& loss, const KnockFit& fit,
                                        const Solver& solver);

/// Two charts of how the point x explains a record: how much later than the nearest predicted
/// impact each knock is, against time; and the plate's angle at each knock, recorded or predicted,
/// against time.
std::vector<report::Chart> knock_charts(const carrier_track::KnockLoss& loss, const Vector& x);

}  // namespace ricochet::studies::identification
