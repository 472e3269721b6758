#include "problems/carrier_track/advice/answer_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "problems/carrier_track/counting/limit.h"
#include "problems/carrier_track/scene/release.h"
#include "problems/carrier_track/scene/window.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;

int count_in(const Scene& scene) {
  return static_cast<int>(std::lround(measured(scene, Measure::collisions)));
}

constexpr double later_turns = 10;

/// The scene with a longer window, by a ratio.
Scene with_longer_window(Scene scene, double ratio) {
  std::visit([ratio](auto& window) { window.count *= ratio; }, scene.window);
  return scene;
}

/// The formula of release_speed(), as far as it is one.
std::string release_formula(const Scene& scene) {
  const bool constant_pull = !scene.pull_rotates && scene.centrifugal == Centrifugal::projected;
  if (!constant_pull || (scene.disturbance != 0 && scene.disturbance_frequency == 0)) {
    return "the swing of the applied force is then as large as its steady part and friction";
  }
  std::string force = "friction normal_force";
  if (scene.pull != 0) force += " + |pull|";
  if (scene.disturbance != 0) force += " - |disturbance|";
  const bool is_sum = scene.pull != 0 || scene.disturbance != 0;
  return fmt::format("sqrt({} / {})", is_sum ? "(" + force + ")" : force,
                     scene.slider_mass_radius == 0
                         ? "centrifugal_mass_radius"
                         : "|centrifugal_mass_radius - slider_mass_radius|");
}

}  // namespace

std::string both_units(double omega) {
  return fmt::format("{:.3f} rad/s ({:.2f} rpm)", omega, omega * rpm);
}

StartShare start_share(const Scene& scene, double omega) {
  const Scene there = at_speed(scene, omega);
  const double turns = turns_of(there);
  const int count = count_in(there);
  const int later = count_in(with_longer_window(there, (turns + later_turns) / turns)) - count;
  const double of_motion = later * turns / later_turns;
  return {omega, turns, count,
          std::clamp(static_cast<int>(std::lround(count - of_motion)), 0, count)};
}

std::optional<StartShare> largest_start_share(const Scene& scene,
                                              const std::vector<double>& speeds) {
  std::optional<StartShare> largest;
  for (const double omega : speeds) {
    const StartShare share = start_share(scene, omega);
    if (!largest || share.of_start > largest->of_start) largest = share;
  }
  return largest;
}

std::string notes_on(const Scene& scene, const std::optional<StartShare>& share) {
  std::string text;
  if (scene.restitution_lower != scene.restitution_upper) {
    text += fmt::format("Restitution is {} at the lower wall and {} at the upper.\n",
                        scene.restitution_lower, scene.restitution_upper);
  }
  const std::optional<double> release = release_speed(scene);
  if (scene.friction * scene.normal_force > 0 && release != 0.0) {
    text += release ? fmt::format("By hand: friction holds the carrier up to {}: {}.\n",
                                  both_units(*release), release_formula(scene))
                    : "By hand: friction and the steady force hold the carrier at every speed.\n";
  }
  if (share && share->dominates()) {
    text += fmt::format(
        "The window of {:.3g} turns is short: {} of its {} collisions at {} are the start's, and "
        "do not come again. Take a longer window.\n",
        share->turns, share->of_start, share->count, both_units(share->omega));
  }
  return text;
}

}  // namespace ricochet::studies::advice
