#pragma once

#include <cmath>
#include <cstdint>

#include "problems/carrier_track/counting/fidelity_choice.h"
#include "problems/carrier_track/models/observer_pair.h"
#include "ricochet/recording.h"
#include "ricochet/simulate.h"

/// The objective of the paper, equations (31)-(33), defined once. A simulation yields features,
/// each with a margin z; a feature counts if z > 0:
///   rule impacts: every impact, z = ln(approach_speed / counting_limit);
///   rule peaks: every local maximum A of x, z = (A - high) / high and z = (low - A) / low.
/// objective_s = sum over features of weight(z, share of the window left after it, s). s = 0 gives
/// the collision count, s > 0 its smooth surrogate. A new impact appears with speed 0, so z =
/// -infinity and weight 0, or enters at the end of the window, where the weight is 0. Under the
/// rule of impacts the surrogate is therefore continuous where the count jumps. Under the rule of
/// peaks it is not: a new maximum may have any height.
namespace ricochet::carrier_track::inline counting {

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

}  // namespace ricochet::carrier_track::inline counting
