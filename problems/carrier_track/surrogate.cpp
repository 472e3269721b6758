#include "problems/carrier_track/surrogate.h"

namespace ricochet::carrier_track {

Slope surrogate_slope(const Scene& scene, double width, double range) {
  const Gradient g = gradient_of<1>(SurrogateOfSpeed{scene, width},
                                    Vector::Constant(1, scene.omega), Vector::Constant(1, range));
  return {g.value, g.gradient[0], g.trust};
}

}  // namespace ricochet::carrier_track
