#pragma once

#include <ceres/jet.h>

#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/motion/observer.h"
#include "problems/carrier_track/motion/profile_forces.h"
#include "ricochet/machine.h"

/// Simulations of dual numbers. They take long to compile, so they are compiled once for each type
/// of dual number that the problems use, in dual_simulation.cpp and dual_hessian_simulation.cpp,
/// for any observer. The cost of a virtual call is negligible compared with the arithmetic of a
/// flight.
namespace ricochet::carrier_track::inline models {

/// The events that a simulation of dual numbers reports. It does not report stretches.
template <Dual Scalar>
class DualObserver {
 public:
  virtual void impact(const Scalar& time, Wall wall, const Scalar& speed) = 0;
  virtual void peak(const Scalar& time, const Scalar& position) = 0;
  virtual void turn(const Scalar& time, const Scalar& position, Wall ahead) = 0;
  virtual void hops(const Scalar& time, Wall wall) = 0;

 protected:
  ~DualObserver() = default;
};

namespace detail {

/// Adapts any observer to a DualObserver.
template <Dual Scalar, class SomeObserver>
class ErasedObserver final : public DualObserver<Scalar> {
 public:
  explicit ErasedObserver(SomeObserver& observer) : observer_(observer) {}

  void impact(const Scalar& time, Wall wall, const Scalar& speed) override {
    observer_.impact(time, wall, speed);
  }
  void peak(const Scalar& time, const Scalar& position) override { observer_.peak(time, position); }
  void turn(const Scalar& time, const Scalar& position, Wall ahead) override {
    observer_.turn(time, position, ahead);
  }
  void hops(const Scalar& time, Wall wall) override { observer_.hops(time, wall); }

 private:
  SomeObserver& observer_;
};

/// Adapts a DualObserver to the interface that the model calls.
template <Dual Scalar>
class Told : public Observer {
 public:
  explicit Told(DualObserver<Scalar>& observer) : observer_(observer) {}

  static constexpr bool hears_stretches() { return false; }

  void impact(const Scalar& time, Wall wall, const Scalar& speed) {
    observer_.impact(time, wall, speed);
  }
  void peak(const Scalar& time, const Scalar& position) { observer_.peak(time, position); }
  void turn(const Scalar& time, const Scalar& position, Wall ahead) {
    observer_.turn(time, position, ahead);
  }
  void hops(const Scalar& time, Wall wall) { observer_.hops(time, wall); }

 private:
  DualObserver<Scalar>& observer_;
};

}  // namespace detail

/// Simulates a valid scene of fidelity impact under the forces of a constant speed or of a profile.
template <class Forces, Dual Scalar>
End<Scalar> simulate_dual(const BasicScene<Scalar>& scene, DualObserver<Scalar>& observer) {
  detail::Told<Scalar> told(observer);
  return ImpactModel<Scalar, Forces>(scene).run(told);
}

// The types that the problems use: for a speed, for a design and a calibration; and the types for
// their second derivatives (gradients/derivatives.h).
using SpeedDual = ceres::Jet<double, 1>;
using DesignDual = ceres::Jet<double, 5>;
using SecondSpeedDual = ceres::Jet<ceres::Jet<double, 1>, 1>;
using SecondDesignDual = ceres::Jet<ceres::Jet<double, 2>, 2>;

// NOLINTBEGIN(bugprone-macro-parentheses): types and a keyword
#define RICOCHET_DUAL_SIMULATION(keyword, Scalar)                                              \
  keyword template End<Scalar> simulate_dual<AppliedForces<Scalar>>(const BasicScene<Scalar>&, \
                                                                    DualObserver<Scalar>&);    \
  keyword template End<Scalar> simulate_dual<ProfileForces<Scalar>>(const BasicScene<Scalar>&, \
                                                                    DualObserver<Scalar>&);
// NOLINTEND(bugprone-macro-parentheses)

RICOCHET_DUAL_SIMULATION(extern, SpeedDual)
RICOCHET_DUAL_SIMULATION(extern, DesignDual)
RICOCHET_DUAL_SIMULATION(extern, SecondSpeedDual)
RICOCHET_DUAL_SIMULATION(extern, SecondDesignDual)

}  // namespace ricochet::carrier_track::inline models
