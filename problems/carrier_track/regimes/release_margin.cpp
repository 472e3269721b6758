#include "problems/carrier_track/regimes/release_margin.h"

#include <cmath>
#include <limits>

#include "problems/carrier_track/flight/applied_forces.h"
#include "problems/carrier_track/regimes/orbit_map.h"
#include "problems/carrier_track/scene/lifted.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

/// The margin of a body that may move up, down, or either way.
template <class Scalar>
Scalar margin_of(const BasicScene<Scalar>& scene, bool up, bool down) {
  using std::sqrt;
  const Scalar zero = constant<Scalar>(0.0);
  const Flight<Scalar> held = AppliedForces<Scalar>(scene).flight(zero, zero, zero);
  Scalar amplitude = zero;
  for (int i = 0; i < held.harmonics; ++i) {
    const auto& [cosine, sine, frequency] = held.acting(i);
    const Scalar square = cosine * cosine + sine * sine;
    if (value(square) > 0) amplitude += sqrt(square);
  }
  const Scalar friction = scene.friction * scene.normal_force / scene.mass;
  const bool upwards = up && (!down || value(held.steady) >= 0);
  return amplitude + (upwards ? held.steady : zero - held.steady) - friction;
}

}  // namespace

double release_margin(const Scene& scene, double position) {
  const bool up = position<scene.wall_upper, down = position> scene.wall_lower;
  if (!up && !down) return -std::numeric_limits<double>::infinity();
  return margin_of(scene, up, down);
}

ReleaseSlopes release_slopes(const Scene& scene, double position, const std::string& constant) {
  BasicScene<OrbitMap::Number> lifted_scene = lifted<OrbitMap::Number>(scene);
  lifted_scene.omega.v[OrbitMap::omega_index] = 1;
  vary_constant(lifted_scene, constant, OrbitMap::constant_index);
  const OrbitMap::Number margin =
      margin_of(lifted_scene, position<scene.wall_upper, position> scene.wall_lower);
  return {margin.a, margin.v[OrbitMap::omega_index], margin.v[OrbitMap::constant_index]};
}

}  // namespace ricochet::carrier_track::inline regimes
