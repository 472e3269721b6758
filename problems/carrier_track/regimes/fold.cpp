#include "problems/carrier_track/regimes/fold.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "problems/carrier_track/regimes/orbit_map.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

constexpr double difference = 1e-7;  // relative, of the margin's derivatives

double margin_of(const OrbitMap& map) {
  const MapInvariants invariants = invariants_of(map, Rest::never);
  return 1 - invariants.trace + invariants.determinant;
}

double margin_at(Scene scene, const Eigen::Vector3d& step) {
  scene.start_position += step[0];
  scene.start_velocity += step[1];
  scene.omega += step[2];
  return margin_of(map_of(scene, Rest::never));
}

}  // namespace

std::optional<double> fold_near(const SteadyMotion& orbit) {
  Scene scene = orbit.orbit;
  const double height = std::max(std::abs(scene.start_position - scene.wall_lower), 1e-12);
  const Eigen::Vector3d scales =
      difference * Eigen::Vector3d(height, orbit.fastest_impact(), scene.omega);
  for (int i = 0; i < 30; ++i) {
    const OrbitMap map = map_of(scene, Rest::never);
    const double margin = margin_of(map);
    Eigen::Matrix3d jacobian;
    for (int k = 0; k < 3; ++k) {
      jacobian(0, k) = map.position.v[k] - (k == OrbitMap::position_index ? 1 : 0);
      jacobian(1, k) = map.velocity.v[k] - (k == OrbitMap::velocity_index ? 1 : 0);
      const Eigen::Vector3d step = scales.cwiseProduct(Eigen::Vector3d::Unit(k));
      jacobian(2, k) = (margin_at(scene, step) - margin) / scales[k];
    }
    const Eigen::Vector3d miss(map.position.a - scene.start_position,
                               map.velocity.a - scene.start_velocity, margin);
    const Eigen::Vector3d step = jacobian.fullPivLu().solve(miss);
    if (!step.allFinite()) return std::nullopt;
    scene.start_position -= step[0];
    scene.start_velocity -= step[1];
    scene.omega -= step[2];
    const bool inside = scene.start_position >= scene.wall_lower &&
                        scene.start_position <= scene.wall_upper &&
                        std::abs(scene.omega / orbit.omega() - 1) < 1e-2;
    if (!inside) return std::nullopt;
    if (std::abs(step[2]) <= 1e-13 * scene.omega && std::abs(margin) < 1e-9) return scene.omega;
  }
  return std::nullopt;
}

}  // namespace ricochet::carrier_track::inline regimes
