#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"
#include "tests/carrier_track/regimes/random_machine.h"

/// What long simulations are compared with regimes by.
namespace ricochet::carrier_track {

/// How near a border [relative] a simulation is: beside irregular motion it is known to 1e-5 only.
inline double beside(const Regime& regime) {
  return regime.ends_by == RegimeEnd::irregular ? 2e-5 : 1e-6;
}

/// Turns that are a multiple of every period up to 8.
inline int whole_periods(const Regime& regime) {
  return regime.turns * (100 / regime.turns);
}

/// The regime of a speed.
inline const Regime& regime_at(const std::vector<Regime>& regimes, double omega) {
  std::size_t i = 0;
  while (omega > regimes.at(i).to) ++i;
  return regimes[i];
}

/// Brings the carrier of an orbit to another speed, in steps of 1 %, or of another factor.
inline Scene brought(Scene scene, double omega, double factor = 1.01) {
  while (scene.omega != omega) {
    scene = at_speed(scene, omega > scene.omega ? std::min(omega, factor * scene.omega)
                                                : std::max(omega, scene.omega / factor));
    scene.window = Revolutions{24};
    Observer nobody;
    const End<double> end = ImpactModel<double>(scene).run(nobody);
    scene.start_position = end.position;
    scene.start_velocity = end.velocity;
  }
  return scene;
}

/// A machine whose speed rises in small steps, and what it counts at each.
class Ramp {
 public:
  explicit Ramp(const Scene& machine) : machine_(machine) {}

  double collisions_per_turn(double omega) {
    constexpr int turns = 80;
    constexpr int observed = 40;
    machine_ = at_speed(machine_, omega);
    machine_.window = Revolutions{turns};
    LateCollisions late(duration_of(machine_) * (turns - observed) / turns,
                        machine_.counting_limit);
    const End<double> end = ImpactModel<double>(machine_).run(late);
    machine_.start_position = end.position;
    machine_.start_velocity = end.velocity;
    return static_cast<double>(late.count()) / observed;
  }

 private:
  Scene machine_;
};

}  // namespace ricochet::carrier_track
