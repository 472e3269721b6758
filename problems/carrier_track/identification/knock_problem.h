#pragma once

#include <vector>

#include "problems/carrier_track/identification/knock_loss.h"
#include "ricochet/problem.h"

namespace ricochet::carrier_track::inline identification {

/// Coordinates z of the unknowns that are fitted, in which a step of 1 in any direction is one
/// standard deviation, as the information at the centre z = 0 has it: solvers need no scaling.
struct KnockCoordinates {
  Vector centre;      ///< of length knock_unknowns
  Matrix directions;  ///< knock_unknowns x n

  /// The point of the unknowns at z (length n), with unknowns that no machine has left out: it is
  /// moved to the nearest that is allowed.
  Vector at(const Vector& z) const;
};

/// The coordinates of these unknowns, by their indices; the others keep their values of `centre`.
KnockCoordinates knock_coordinates(const KnockLoss& loss, const Vector& centre, double blur,
                                   const std::vector<Eigen::Index>& free);

/// To minimise a loss of this blur [rad] over z, within `reach` deviations. Both must outlive it.
Problem knock_problem(const KnockLoss& loss, const KnockCoordinates& coordinates, double blur,
                      double reach = 10);

}  // namespace ricochet::carrier_track::inline identification
