#include "problems/carrier_track/identification/safe_speed.h"

#include <cmath>
#include <vector>

#include "problems/carrier_track/counting/counts.h"

namespace ricochet::carrier_track::inline identification {
namespace {

constexpr double allowed_per_turn = 2;
constexpr int turns = 8;
constexpr double ratio = 1.005;  // of neighbouring speeds of the scan

/// From rest on a wall a carrier reaches its steady motion within a turn.
Scene from_rest(Scene scene, double turns) {
  scene.start_position = scene.wall_lower;
  scene.start_velocity = 0;
  scene.window = Revolutions{turns};
  return scene;
}

}  // namespace

std::optional<double> safe_speed(const Scene& scene, double fastest) {
  const Scene first = from_rest(scene, 2);
  const Scene all = from_rest(scene, 2 + turns);
  // Counts in the turns after the first two, as the difference of two windows.
  const auto loud = [&](const std::vector<double>& speeds) {
    const std::vector<int> before = counts_at(first, speeds);
    const std::vector<int> after = counts_at(all, speeds);
    std::vector<bool> result;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      result.push_back(after[i] - before[i] > allowed_per_turn * turns);
    }
    return result;
  };
  std::vector<double> speeds;
  for (double omega = fastest; omega > fastest / 200; omega /= ratio) speeds.push_back(omega);
  const std::vector<bool> scan = loud({speeds.rbegin(), speeds.rend()});
  std::size_t k = 0;
  while (k < scan.size() && !scan[k]) ++k;
  if (k == scan.size()) return std::nullopt;
  double above = speeds[speeds.size() - 1 - k];
  double below = above / ratio;
  for (int i = 0; i < 40 && above - below > 1e-12 * above; ++i) {
    const double middle = (below + above) / 2;
    (loud({middle}).front() ? above : below) = middle;
  }
  return below;
}

}  // namespace ricochet::carrier_track::inline identification
