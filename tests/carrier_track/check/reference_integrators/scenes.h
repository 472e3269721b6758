#pragma once

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "tests/carrier_track/models/brute_force.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {

inline Integrator find_integrator(const std::string& name) {
  for (const Integrator& integrator : all_integrators()) {
    if (integrator.name == name) return integrator;
  }
  throw std::invalid_argument("no integrator " + name);
}

/// Those with this kind of setting.
inline std::vector<Integrator> integrators_by(std::string_view setting) {
  std::vector<Integrator> chosen = all_integrators();
  std::erase_if(chosen, [&](const Integrator& i) { return i.setting != setting; });
  return chosen;
}

inline bool steps_evenly(const Integrator& integrator) {
  return integrator.setting == by_step;
}

/// A finished run.
inline Outcome run(const Integrator& integrator, const Scene& scene, double control) {
  const Outcome outcome = integrator.run(scene, control);
  EXPECT_TRUE(outcome.finished && outcome.failure.empty())
      << integrator.name << ": " << outcome.failure;
  return outcome;
}

inline Outcome run(const std::string& integrator, const Scene& scene, double control) {
  return run(find_integrator(integrator), scene, control);
}

inline Outcome reference(const Scene& scene) {
  return run("event-driven", scene, 0.0);
}

/// Calls `look(outcome, integrator)` for a finished run of each integrator with hard walls.
template <class Look>
void for_each_run(const Scene& scene, double step, double tolerance, const Look& look) {
  for (const Integrator& integrator : all_integrators()) {
    if (integrator.setting == by_depth) continue;
    SCOPED_TRACE(integrator.name);
    look(run(integrator, scene, steps_evenly(integrator) ? step : tolerance), integrator);
  }
}

/// The largest difference of the times [s] of fast impacts, those that the scene counts, and their
/// partners. These are on the same wall, no further apart than half the mean time between the
/// reference's fast impacts, and at least half as fast as what counts, so that an impact just above
/// the limit still has one that is slightly slower. Infinite if an impact of either has none.
inline double time_error(const Scene& scene, const Outcome& outcome, const Outcome& reference) {
  const double window = 0.5 * duration_of(scene) / std::max(collisions(scene, reference), 1);
  double largest = 0;
  for (const auto& [these, those] : {std::pair(&outcome, &reference), {&reference, &outcome}}) {
    const std::vector<Impact> partners = faster(those->impacts, 0.5 * scene.counting_limit);
    auto next = partners.begin();
    for (const Impact& impact : faster(these->impacts, scene.counting_limit)) {
      next = std::find_if(next, partners.end(), [&](const Impact& partner) {
        return partner.wall == impact.wall && std::abs(partner.time - impact.time) <= window;
      });
      if (next == partners.end()) return infinity;
      largest = std::max(largest, std::abs((next++)->time - impact.time));
    }
  }
  return largest;
}

inline Scene paper_scene(const std::string& id, double omega) {
  return at_speed(scene_of(find_case(id), exploratory_scene()), omega);
}

/// A ball dropped from 50 m on a floor at 0: its impacts are a geometric series.
inline Scene bouncing_ball() {
  return with(falling_ball(50, 9.8, 0.8), set::seconds(40));
}
inline const std::vector<Bounce> bounces = bounces_of(50, 9.8, 0.8, 20);

/// A block that slides to and fro, 1 m from each wall, with friction 0.25 x 2 N on 0.8 kg.
inline Scene block() {
  return with(Scene{}, set::walls(-1, 1), set::start_position(0), set::mass(0.8),
              set::friction(0.25), set::normal_force(2));
}
inline constexpr double block_friction = 0.25 * 2.0 / 0.8;  // [m/s^2]

/// A free mass between two shaken walls, e = 0.5, on its way to the stable symmetric orbit with two
/// impacts a period; the gap has 5 amplitudes.
inline Scene shaken_gap() {
  const double amplitude = 2e-4;                         // [m]
  const double frequency = 2 * std::numbers::pi * 10.0;  // [rad/s]
  return with(Scene{}, set::wall_upper(5 * amplitude), set::restitution(0.5),
              set::disturbance(amplitude * frequency * frequency),
              set::disturbance_frequency(frequency), set::start(0.5e-3, 0.03), set::seconds(2));
}

}  // namespace ricochet::carrier_track
