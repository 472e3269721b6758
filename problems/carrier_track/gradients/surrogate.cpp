#include "problems/carrier_track/gradients/surrogate.h"

#include <cmath>

#include "problems/carrier_track/scene/lifted.h"

namespace ricochet::carrier_track::inline gradients {

Slope surrogate_slope(const Scene& scene, double smoothing, double range) {
  using Jet = ceres::Jet<double, 1>;
  BasicScene<Jet> dual = lifted<Jet>(scene);
  dual.omega.v[0] = 1.0;
  const Vector smoothings = Vector::Constant(1, range);
  TrustGauge<Jet> gauge(smoothings, 0);
  auto watcher = gauge.of(dual);
  const Jet result = objective(dual, smoothing, watcher);
  const double slope = result.v[0];
  return {result.a, slope,
          trust_of(std::pow(gauge.steepest(), 2), std::pow(gauge.growth(), 2),
                   std::abs(slope) * range)};
}

}  // namespace ricochet::carrier_track::inline gradients
