#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "problems/carrier_track/motion/observer.h"
#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline counting {

/// Returns true if the second direction of a scene can affect the first: the carrier may move in y,
/// or be pressed to a wall there, and friction couples the directions. If not, x is the same
/// without y.
bool couples(const Scene& scene);

/// The cheapest level whose count is certain for a valid scene. Fidelity auto selects it:
///   planar, if the scene has a second direction that couples;
///   else impact, if its count is certain;
///   else compliant, if its count is certain, with the scene's contact law and stiffness;
///   else impact: no level makes this count certain.
/// Costs up to ten simulations.
Fidelity needed_fidelity(const Scene& scene);

/// The scene with fidelity auto replaced by the needed level.
Scene resolve_fidelity(const Scene& scene);

/// simulate() for a scene that may have fidelity auto. The level is chosen for this scene, so it
/// may differ from one speed to the next.
template <class Scalar, class SomeObserver>
End<Scalar> simulate_at_needed_fidelity(const BasicScene<Scalar>& scene, SomeObserver& observer) {
  if constexpr (std::is_same_v<Scalar, double>) {
    if (scene.fidelity == Fidelity::automatic) return simulate(resolve_fidelity(scene), observer);
  }
  return simulate(scene, observer);
}

// The objective of the paper, equations (31)-(33), defined once. A simulation yields features,
// each with a margin z; a feature counts if z > 0:
//   rule impacts: every impact, z = ln(approach_speed / counting_limit);
//   rule peaks: every local maximum A of x, z = (A - high) / high and z = (low - A) / low.
// objective_s = sum over features of weight(z, share of the window left after it, s). s = 0 gives
// the collision count, s > 0 its smooth surrogate. A new impact appears with speed 0, so z =
// -infinity and weight 0, or enters at the end of the window, where the weight is 0. Under the
// rule of impacts the surrogate is therefore continuous where the count jumps. Under the rule of
// peaks it is not: a new maximum may have any height.

/// Weight of a feature of margin z at smoothing parameter s: the Heaviside step (1 where z > 0) for
/// s = 0, else the logistic 1 / (1 + exp(-z / s)).
template <class Scalar>
Scalar step(const Scalar& z, double smoothing) {
  using std::exp;
  if (smoothing == 0.0) return constant<Scalar>(value(z) > 0 ? 1.0 : 0.0);
  const Scalar scaled = z / constant<Scalar>(smoothing);
  if (value(scaled) < -700) return constant<Scalar>(0.0);  // exp would overflow; the weight is 0
  return constant<Scalar>(1.0) / (constant<Scalar>(1.0) + exp(-scaled));
}

/// Margin of an impact at an approach speed > 0, under the rule of impacts.
template <class Scalar>
Scalar impact_margin(const Scalar& speed, const Scalar& counting_limit) {
  using std::log;
  return log(speed / counting_limit);
}

/// Returns true if the impact counts: step() of its margin at smoothing parameter 0, without the
/// logarithm.
inline bool is_counted(double speed, double counting_limit) {
  return speed / counting_limit > 1;
}

/// The share of the window, per unit of smoothing parameter, over which a surrogate's weights fade
/// at its end.
inline constexpr double fading_share = 0.1;

/// The factor on a feature's weight if the share `left` >= 0 of the window is after it: 1 for
/// smoothing parameter 0, else 1 - exp(-(left / (fading_share smoothing parameter))^2), which is
/// smooth.
template <class Scalar>
Scalar fading(const Scalar& left, double smoothing) {
  using std::exp;
  const double faded = fading_share * smoothing;
  if (smoothing == 0 || value(left) >= 6.5 * faded)
    return constant<Scalar>(1.0);  // exp is below half a unit of rounding
  const Scalar scaled = left / constant<Scalar>(faded);
  return constant<Scalar>(1.0) - exp(-(scaled * scaled));
}

/// Weight of a feature at a smoothing parameter.
template <class Scalar>
Scalar weight(const Scalar& z, const Scalar& left, double smoothing) {
  return step(z, smoothing) * fading(left, smoothing);
}

/// Calls `use(z, left)` for every feature of the motion under the rule of `scene`, with its margin
/// and the share of the window after it.
template <class Scalar, class Use>
class Features : public Observer {
 public:
  Features(const BasicScene<Scalar>& scene, Use use)
      : scene_(scene), duration_(duration_of(scene)), use_(use) {}

  void impact(const Scalar& time, Wall /*wall*/, const Scalar& speed) {
    if (scene_.rule != CountRule::impacts || value(speed) <= 0) return;
    use_(impact_margin(speed, scene_.counting_limit), left_after(time));
  }

  void peak(const Scalar& time, const Scalar& position) {
    if (scene_.rule != CountRule::peaks) return;
    use_(Scalar((position - scene_.peak_high) / scene_.peak_high), left_after(time));
    use_(Scalar((scene_.peak_low - position) / scene_.peak_low), left_after(time));
  }

 protected:
  const Use& use() const { return use_; }

 private:
  Scalar left_after(const Scalar& time) const { return constant<Scalar>(1.0) - time / duration_; }

  const BasicScene<Scalar>& scene_;
  Scalar duration_;
  Use use_;
};

/// Adds the weights of features.
template <class Scalar>
struct AddWeight {
  double smoothing;
  Scalar sum = constant<Scalar>(0.0);

  void operator()(const Scalar& z, const Scalar& left) { sum += weight(z, left, smoothing); }
};

/// The sum of the weights of the features of a motion: objective_s of a scene, which must outlive
/// it.
template <class Scalar>
class WeightSum : public Features<Scalar, AddWeight<Scalar>> {
 public:
  WeightSum(const BasicScene<Scalar>& scene, double smoothing)
      : Features<Scalar, AddWeight<Scalar>>(scene, {smoothing}) {}

  const Scalar& total() const { return this->use().sum; }
};

/// objective_s of a valid scene: the collision count for smoothing parameter s = 0, its surrogate
/// for s > 0. `also` observes the simulation too.
template <class Scalar, class Also>
Scalar objective(const BasicScene<Scalar>& scene, double smoothing, Also& also) {
  WeightSum<Scalar> sum(scene, smoothing);
  ObserverPair both(sum, also);
  simulate_at_needed_fidelity(scene, both);
  return sum.total();
}

template <class Scalar>
Scalar objective(const BasicScene<Scalar>& scene, double smoothing) {
  Observer nobody;
  return objective(scene, smoothing, nobody);
}

/// Smoothing parameter of the fading at the end of the window, where an impact would otherwise
/// leave with all its energy.
inline constexpr double wear_smoothing = 0.25;

/// mass (1 - restitution^2) / 2, with a wall's restitution reduced by contact friction: times the
/// square of the approach speed it is the energy [J] that an impact on that wall dissipates.
template <class Scalar>
Scalar impact_loss(const BasicScene<Scalar>& scene, Wall wall) {
  const Scalar restitution =
      wall == Wall::lower ? lower_restitution(scene) : upper_restitution(scene);
  const Scalar half = constant<Scalar>(0.5);
  return half * scene.mass * (constant<Scalar>(1.0) - restitution * restitution);
}

/// Sums the kinetic energy that impacts dissipate.
template <class Scalar>
class EnergyLost : public Observer {
 public:
  explicit EnergyLost(const BasicScene<Scalar>& scene)
      : lower_(impact_loss(scene, Wall::lower)),
        upper_(impact_loss(scene, Wall::upper)),
        duration_(duration_of(scene)) {}

  void impact(const Scalar& time, Wall wall, const Scalar& speed) {
    const Scalar left = constant<Scalar>(1.0) - time / duration_;
    sum_ += fading(left, wear_smoothing) * (wall == Wall::lower ? lower_ : upper_) * speed * speed;
  }

  Scalar total() const { return constant<Scalar>(1e3) * sum_; }  ///< [mJ]

 private:
  Scalar lower_, upper_;
  Scalar duration_;
  Scalar sum_ = constant<Scalar>(0.0);  // [J]
};

/// The wear of a valid scene [mJ]: the energy that all impacts of the window dissipate in track and
/// carrier (wear increases with the work done: Archard, J. Appl. Phys. 24 (1953) 981). It is smooth
/// where the count jumps: a new impact appears with speed 0, or enters at the end of the window,
/// where its weight is 0 (count.h). The energy of impacts slower than resting_speed is
/// omitted. `also` observes the simulation too.
template <class Scalar, class Also>
Scalar wear(const BasicScene<Scalar>& scene, Also& also) {
  EnergyLost<Scalar> lost(scene);
  ObserverPair both(lost, also);
  simulate_at_needed_fidelity(scene, both);
  return lost.total();
}

template <class Scalar>
Scalar wear(const BasicScene<Scalar>& scene) {
  Observer nobody;
  return wear(scene, nobody);
}

// A limit that a user sets on the collisions, the energy or the impact speed of a machine.

/// The measure of a valid scene at the speed of the scene.
double measured(const Scene& scene, Measure measure);

/// The same at several speeds [rad/s]; neighbours should be similar.
std::vector<double> measured_at(const Scene& scene, Measure measure,
                                std::span<const double> speeds);

/// At the speeds step, 2 step, ..., highest [rad/s], or as many of the slowest as the TimeLimit
/// allows: 1 where the limit is exceeded, 0 where it is kept.
SpeedScan scan_by(const Scene& scene, const Limit& limit, double step, double highest);

}  // namespace ricochet::carrier_track::inline counting
