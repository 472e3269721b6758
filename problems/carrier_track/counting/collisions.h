#pragma once

#include <cmath>
#include <cstdint>

#include "problems/carrier_track/counting/fidelity_choice.h"
#include "problems/carrier_track/models/observer_pair.h"

/// The objective of the paper, equations (31)-(33), defined once. A simulation yields features,
/// each with a margin z that is positive when it counts:
///   rule impacts: every impact, z = ln(approach_speed / slowest);
///   rule peaks: every local maximum A of x, z = (A - high) / high and z = (low - A) / low.
/// objective_s = sum over features of weight(z, share of the window left after it, s). s = 0 gives
/// the collision count, s > 0 its smooth surrogate. An impact is born with speed 0, so z =
/// -infinity and weight 0, or enters at the end of the window, where the weight fades: under the
/// rule of impacts the surrogate is continuous where the count jumps. Under the rule of peaks it is
/// not: a maximum is born at any height.
namespace ricochet::carrier_track::inline counting {

/// Smoothing width where nobody asks for another: an impact counts half at the limit, 0.9 at 1.73
/// times its speed.
inline constexpr double default_width = 0.25;

/// Weight of a feature of margin z at smoothing width s: the Heaviside step (1 where z > 0) for
/// s = 0, else the logistic 1 / (1 + exp(-z / s)).
template <class Scalar>
Scalar step(const Scalar& z, double width) {
  using std::exp;
  if (width == 0.0) return constant<Scalar>(value(z) > 0 ? 1.0 : 0.0);
  const Scalar scaled = z / constant<Scalar>(width);
  if (value(scaled) < -700) return constant<Scalar>(0.0);  // exp would overflow; the weight is 0
  return constant<Scalar>(1.0) / (constant<Scalar>(1.0) + exp(-scaled));
}

/// Margin of an impact at an approach speed > 0, under the rule of impacts.
template <class Scalar>
Scalar impact_margin(const Scalar& speed, const Scalar& slowest) {
  using std::log;
  return log(speed / slowest);
}

/// Whether it counts: step() of its margin at width 0, without the logarithm.
inline bool is_counted(double speed, double slowest) {
  return speed / slowest > 1;
}

/// How much of the window, for each unit of smoothing width, a surrogate fades at the end.
inline constexpr double fading_share = 0.1;

/// Part of its weight that a feature keeps with the share `left` >= 0 of the window after it: 1 for
/// width 0, else 1 - exp(-(left / (fading_share width))^2), which has no corner.
template <class Scalar>
Scalar fading(const Scalar& left, double width) {
  using std::exp;
  const double faded = fading_share * width;
  if (width == 0 || value(left) >= 6.5 * faded)
    return constant<Scalar>(1.0);  // exp is below half a rounding
  const Scalar scaled = left / constant<Scalar>(faded);
  return constant<Scalar>(1.0) - exp(-(scaled * scaled));
}

/// Weight of a feature at a smoothing width.
template <class Scalar>
Scalar weight(const Scalar& z, const Scalar& left, double width) {
  return step(z, width) * fading(left, width);
}

/// Calls `use(z, left)` for every feature that the rule of `scene` makes of the motion, with its
/// margin and the share of the window after it.
template <class Scalar, class Use>
class Features : public Observer {
 public:
  Features(const BasicScene<Scalar>& scene, Use use)
      : scene_(scene), duration_(duration_of(scene)), use_(use) {}

  void impact(const Scalar& time, Wall /*wall*/, const Scalar& speed) {
    if (scene_.rule != CountRule::impacts || value(speed) <= 0) return;
    use_(impact_margin(speed, scene_.slowest), left_after(time));
  }

  void peak(const Scalar& time, const Scalar& position) {
    if (scene_.rule != CountRule::peaks) return;
    use_(Scalar((position - scene_.peak_high) / scene_.peak_high), left_after(time));
    use_(Scalar((scene_.peak_low - position) / scene_.peak_low), left_after(time));
  }

 private:
  Scalar left_after(const Scalar& time) const { return constant<Scalar>(1.0) - time / duration_; }

  const BasicScene<Scalar>& scene_;
  Scalar duration_;
  Use use_;
};

/// objective_s of a valid scene: the collision count for width s = 0, its surrogate for s > 0. The
/// simulation is shown to `also`, too.
template <class Scalar, class Also>
Scalar objective(const BasicScene<Scalar>& scene, double width, Also& also) {
  Scalar sum = constant<Scalar>(0.0);
  auto add = [&](const Scalar& z, const Scalar& left) { sum += weight(z, left, width); };
  Features<Scalar, decltype(add)> features(scene, add);
  ObserverPair both(features, also);
  simulate_at_needed_fidelity(scene, both);
  return sum;
}

template <class Scalar>
Scalar objective(const BasicScene<Scalar>& scene, double width) {
  Observer nobody;
  return objective(scene, width, nobody);
}

}  // namespace ricochet::carrier_track::inline counting
