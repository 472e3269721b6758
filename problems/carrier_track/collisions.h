#pragma once

#include <cmath>
#include <cstdint>

#include "problems/carrier_track/both.h"
#include "problems/carrier_track/simulate.h"

/// The objective of the paper, equations (31)-(33), defined once. A simulation yields features,
/// each with a margin z that is positive when it counts:
///   rule impacts: every impact, z = ln(approach_speed / slowest);
///   rule peaks: every local maximum A of x, z = (A - high) / high and z = (low - A) / low.
/// objective_s = sum over features of step(z, s). s = 0 gives the collision count, s > 0 its smooth
/// surrogate. An impact is born with speed 0, so z = -infinity and weight 0: the surrogate is
/// continuous where the count jumps. It jumps only where an impact at speed leaves or enters by the
/// end of the window, as the count does.
namespace ricochet::carrier_track {

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

/// Calls `use(z)` with the margin of every feature that the rule of `scene` makes of the motion.
template <class Scalar, class Use>
class Features : public Observer {
 public:
  Features(const BasicScene<Scalar>& scene, Use use) : scene_(scene), use_(use) {}

  void impact(const Scalar& /*time*/, Wall /*wall*/, const Scalar& speed) {
    using std::log;
    if (scene_.rule != CountRule::impacts || value(speed) <= 0) return;
    use_(Scalar(log(speed / scene_.slowest)));
  }

  void peak(const Scalar& /*time*/, const Scalar& position) {
    if (scene_.rule != CountRule::peaks) return;
    use_(Scalar((position - scene_.peak_high) / scene_.peak_high));
    use_(Scalar((scene_.peak_low - position) / scene_.peak_low));
  }

 private:
  const BasicScene<Scalar>& scene_;
  Use use_;
};

/// objective_s of a valid scene: the collision count for width s = 0, its surrogate for s > 0. The
/// simulation is shown to `also`, too.
template <class Scalar, class Also>
Scalar objective(const BasicScene<Scalar>& scene, double width, Also& also) {
  Scalar sum = constant<Scalar>(0.0);
  auto add = [&](const Scalar& z) { sum += step(z, width); };
  Features<Scalar, decltype(add)> features(scene, add);
  Both both(features, also);
  simulate(scene, both);
  return sum;
}

template <class Scalar>
Scalar objective(const BasicScene<Scalar>& scene, double width) {
  Observer nobody;
  return objective(scene, width, nobody);
}

}  // namespace ricochet::carrier_track
