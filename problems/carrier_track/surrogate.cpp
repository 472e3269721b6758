#include "problems/carrier_track/surrogate.h"

#include <ceres/jet.h>

#include "problems/carrier_track/collisions.h"

namespace ricochet::carrier_track {

Slope surrogate_slope(const Scene& scene, double width) {
  using Jet = ceres::Jet<double, 1>;
  BasicScene<Jet> dual = lifted<Jet>(scene);
  dual.omega.v[0] = 1.0;
  const Jet result = objective(dual, width);
  return {result.a, result.v[0]};
}

}  // namespace ricochet::carrier_track
