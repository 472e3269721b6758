#pragma once

#include "problems/carrier_track/counting/collisions.h"

namespace ricochet::carrier_track::inline counting {

/// Width of the fading to the end of the window, where an impact would leave with all its energy.
inline constexpr double wear_width = 0.25;

/// Adds up the kinetic energy [J] that the walls take: an impact of approach speed v loses
/// mass (1 - restitution^2) v^2 / 2, with the restitution that friction in contact leaves.
template <class Scalar>
class EnergyLost : public Observer {
 public:
  explicit EnergyLost(const BasicScene<Scalar>& scene)
      : lower_(share_lost(scene, lower_restitution(scene))),
        upper_(share_lost(scene, upper_restitution(scene))),
        duration_(duration_of(scene)) {}

  void impact(const Scalar& time, Wall wall, const Scalar& speed) {
    const Scalar left = constant<Scalar>(1.0) - time / duration_;
    sum_ += fading(left, wear_width) * (wall == Wall::lower ? lower_ : upper_) * speed * speed;
  }

  const Scalar& sum() const { return sum_; }

 private:
  static Scalar share_lost(const BasicScene<Scalar>& scene, const Scalar& restitution) {
    const Scalar half = constant<Scalar>(0.5);
    return half * scene.mass * (constant<Scalar>(1.0) - restitution * restitution);
  }

  Scalar lower_, upper_;
  Scalar duration_;
  Scalar sum_ = constant<Scalar>(0.0);
};

/// The wear of a valid scene [mJ]: the energy that track and carrier take in all impacts of the
/// window (Archard, J. Appl. Phys. 24 (1953) 981, has wear grow with the work done). Smooth by
/// itself where the count jumps: an impact is born with speed 0, or enters at the end of the
/// window, to which it fades (collisions.h). What impacts slower than resting_speed lose is left
/// out. The simulation is shown to `also`, too.
template <class Scalar, class Also>
Scalar wear(const BasicScene<Scalar>& scene, Also& also) {
  EnergyLost<Scalar> lost(scene);
  ObserverPair both(lost, also);
  simulate_at_needed_fidelity(scene, both);
  return constant<Scalar>(1e3) * lost.sum();
}

template <class Scalar>
Scalar wear(const BasicScene<Scalar>& scene) {
  Observer nobody;
  return wear(scene, nobody);
}

}  // namespace ricochet::carrier_track::inline counting
