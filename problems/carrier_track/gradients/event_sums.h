#pragma once

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/wear.h"

/// The sums over the events of a motion that problems minimise. Each makes the observer that adds
/// up a motion of `scene`, which must outlive it, for every scalar type; its total() is the sum.
namespace ricochet::carrier_track::inline gradients {

/// objective_s of collisions.h.
struct SurrogateSum {
  double smoothing;

  template <class Scalar>
  WeightSum<Scalar> over(const BasicScene<Scalar>& scene) const {
    return {scene, smoothing};
  }
};

/// The wear [mJ] of wear.h.
struct WearSum {
  template <class Scalar>
  EnergyLost<Scalar> over(const BasicScene<Scalar>& scene) const {
    return EnergyLost<Scalar>(scene);
  }
};

}  // namespace ricochet::carrier_track::inline gradients
