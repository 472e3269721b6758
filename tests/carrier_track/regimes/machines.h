#pragma once

#include <algorithm>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/random.h"
#include "tests/support/scenes.h"

/// Machines whose regimes are looked at, and the long simulations that they are compared with.
namespace ricochet::carrier_track {

/// Draws numbers of a machine.
class MachineDraw {
 public:
  explicit MachineDraw(std::uint64_t seed) : random_(seed) {}

  double even(double low, double high) { return low + (high - low) * uniform(random_); }
  double even_logarithm(double low, double high) {
    return std::exp(even(std::log(low), std::log(high)));
  }
  bool in(double share) { return uniform(random_) < share; }

 private:
  Random random_;
};

/// A machine of any size and forces, without disturbance.
inline Scene random_machine(std::uint64_t seed) {
  MachineDraw draw(seed);
  Scene scene;
  scene.mass = draw.even_logarithm(0.3, 3);
  scene.wall_upper = draw.even_logarithm(2e-4, 5e-3);
  scene.restitution_lower = scene.restitution_upper = draw.even(0, 0.95);
  if (draw.in(0.3)) scene.restitution_upper = draw.even(0, 0.95);
  scene.friction = draw.in(0.15) ? 0 : draw.even(0.02, 0.5);
  scene.normal_force = draw.even_logarithm(1, 30);
  scene.contact_friction = draw.in(0.5);
  scene.pull = draw.in(0.2) ? 0 : draw.even_logarithm(0.005, 3) * (draw.in(0.2) ? -1 : 1);
  scene.centrifugal_mass_radius = draw.even_logarithm(0.02, 1);
  scene.pull_rotates = draw.in(0.3);
  if (scene.pull_rotates) scene.pull_phase = draw.even(-3, 3);
  if (draw.in(0.3)) scene.slider_mass_radius = draw.even_logarithm(1e-4, 0.05);
  scene.phase = draw.even(-3, 3);
  scene.start_position = draw.even(0, 1) * scene.wall_upper;
  scene.counting_limit = draw.even_logarithm(1e-3, 2e-2);
  return scene;
}

/// The same with a disturbance.
inline Scene random_disturbed_machine(std::uint64_t seed) {
  Scene scene = random_machine(seed);
  MachineDraw draw(seed + 1'000'000);
  scene.disturbance = draw.even_logarithm(0.01, 1);
  scene.disturbance_frequency = draw.even_logarithm(0.2, 5);
  return scene;
}

/// A machine as strange as a file may describe it, and valid: its numbers are drawn over several
/// powers of ten, restitution up to 0.9999, clearance from 1e-6 m, a disturbance of up to eight
/// times friction at 0.1 to 60 rad/s. One in ten has no upper wall; some are not about impacts on
/// hard walls.
inline Scene strange_machine(std::uint64_t seed) {
  MachineDraw draw(seed + 2'000'000);
  const auto restitution = [&] { return draw.in(0.1) ? 0 : 1 - draw.even_logarithm(1e-4, 1); };
  Scene scene;
  scene.mass = draw.even_logarithm(0.01, 30);
  scene.wall_upper = draw.even_logarithm(1e-6, 0.1);
  scene.start_position = draw.even(0, 1) * scene.wall_upper;
  if (draw.in(0.1)) scene.wall_upper = infinity;
  scene.restitution_lower = scene.restitution_upper = restitution();
  if (draw.in(0.3)) scene.restitution_upper = restitution();
  scene.friction = draw.in(0.2) ? 0 : draw.even(0.01, 1);
  scene.normal_force = draw.even_logarithm(0.1, 100);
  scene.contact_friction = draw.in(0.3);
  scene.pull = draw.in(0.25) ? 0 : draw.even_logarithm(1e-3, 30) * (draw.in(0.3) ? -1 : 1);
  scene.pull_rotates = draw.in(0.3);
  scene.pull_phase = draw.even(-3, 3);
  scene.centrifugal_mass_radius = draw.in(0.05) ? 0 : draw.even_logarithm(1e-3, 3);
  if (draw.in(0.2)) {
    scene.centrifugal = draw.in(0.5) ? Centrifugal::inward : Centrifugal::outward;
  }
  scene.slider_mass_radius = draw.in(0.7) ? 0 : draw.even_logarithm(1e-5, 0.3);
  scene.phase = draw.even(-3, 3);
  if (draw.in(0.6)) {
    const double held = std::max(scene.friction * scene.normal_force, 0.01);
    scene.disturbance = held * draw.even_logarithm(0.03, 8) * (draw.in(0.2) ? -1 : 1);
    scene.disturbance_frequency = draw.even_logarithm(0.1, 60);
  }
  if (draw.in(0.5)) scene.start_velocity = draw.even(-1, 1) * draw.even_logarithm(1e-3, 1);
  scene.counting_limit = draw.even_logarithm(1e-5, 5e-2);
  scene.window = Revolutions{draw.even_logarithm(1, 50)};
  if (draw.in(0.1)) scene.fidelity = draw.in(0.5) ? Fidelity::automatic : Fidelity::compliant;
  if (draw.in(0.05)) scene.rule = CountRule::peaks;
  return scene;
}

/// What the turns of a long simulation count and lose from a time on.
struct LateTurns : Observer {
  const Scene& scene;
  double from;
  int collisions = 0;
  double energy = 0;

  void impact(double time, Wall wall, double speed) {
    if (time < from || speed <= 0) return;
    if (is_counted(speed, scene.counting_limit)) ++collisions;
    energy += impact_loss(scene, wall) * speed * speed;
  }
};

/// A turn's share of what the last `observed` of `turns` turns from the scene's start have.
struct InTheLongRun {
  double collisions, energy;
  End<double> end;
};

inline InTheLongRun simulated_turns(Scene scene, double omega, int turns, int observed) {
  scene = at_speed(scene, omega);
  scene.window = Revolutions{static_cast<double>(turns)};
  LateTurns late{{}, scene, duration_of(scene) * (turns - observed) / turns};
  const End<double> end = ImpactModel<double>(scene).run(late);
  return {static_cast<double>(late.collisions) / observed, late.energy / observed, end};
}

inline double collisions_in_the_long_run(const Scene& scene, double omega, int turns,
                                         int observed) {
  return simulated_turns(scene, omega, turns, observed).collisions;
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
    const double next = omega > scene.omega ? std::min(omega, factor * scene.omega)
                                            : std::max(omega, scene.omega / factor);
    const End<double> end = simulated_turns(scene, next, 24, 1).end;
    scene =
        with(at_speed(scene, next), set::revolutions(24), set::start(end.position, end.velocity));
  }
  return scene;
}

/// Calls look(regime, omega, collisions) in the certain regimes of a machine whose speed rises in
/// steps of 0.1 %, with what it counts in a turn; but not next to the borders: it is late by a
/// step.
template <class Look>
void look_evenly(Scene machine, const std::vector<Regime>& regimes, const Look& look) {
  for (double omega = regimes.front().from; omega < regimes.back().to; omega *= 1.001) {
    const InTheLongRun turns = simulated_turns(machine, omega, 80, 40);
    machine = with(machine, set::start(turns.end.position, turns.end.velocity));
    const Regime& regime = regime_at(regimes, omega);
    if (omega < regime.from * 1.002 || omega > regime.to * 0.999 || !regime.certain) continue;
    look(regime, omega, turns.collisions);
  }
}

/// Calls look(regime, omega, orbit) in each certain regime at a random speed and just inside both
/// borders, with the motion at the nearer one.
template <class Look>
void look_into_each(const std::vector<Regime>& regimes, std::uint64_t seed, const Look& look) {
  MachineDraw draw(seed + 7'000'000);
  double reach = 0;  // from the border before
  for (const Regime& regime : regimes) {
    const double slow = regime.from * (1 + reach);
    // Beside irregular motion a border is known to 1e-5 only.
    reach = regime.ends_by == RegimeEnd::irregular ? 2e-5 : 1e-6;
    const double fast = regime.to * (1 - reach);
    if (!regime.certain || !(slow < fast)) continue;
    for (const double omega : {slow, draw.even(slow, fast), fast}) {
      const bool early = omega - regime.from < regime.to - omega;
      look(regime, omega, early ? regime.first.orbit : regime.last.orbit);
    }
  }
}

/// Even phases of a turn, from 0.
inline std::vector<double> even_phases(int count) {
  std::vector<double> phases;
  for (int k = 0; k < count; ++k) phases.push_back(2 * std::numbers::pi * k / count);
  return phases;
}

/// The fewest and the most collisions of the turns at many even phases.
inline std::pair<int, int> extremes_of(const DisturbedMotion& motion, int phases) {
  const auto turns = turns_at_phases(motion.machine, even_phases(phases), motion.turns_before);
  const auto [least, most] = std::ranges::minmax_element(turns, {}, &DisturbedTurn::collisions);
  return {least->collisions, most->collisions};
}

/// A ball on a table that shakes as A sin(omega t), in the table's frame: it can strike once in
/// every period. The closed forms are in units of the gravity.
namespace shaken_table {

inline constexpr double gravity = 9.81;
inline constexpr double amplitude = 0.01;

/// The peak acceleration at which the orbit begins to exist.
inline double fold_strength(double e) {
  return std::numbers::pi * (1 - e) / (1 + e);
}

/// The peak acceleration at which its period doubles.
inline double flip_strength(double e) {
  return std::hypot(fold_strength(e), 2 * (1 + e * e) / ((1 + e) * (1 + e)));
}

/// The speed [rad/s] at which the table has that peak acceleration.
inline double speed_at(double strength) {
  return std::sqrt(strength * gravity / amplitude);
}

/// The ball on the stable orbit, leaving the table.
inline Scene on_orbit(double e, double strength) {
  const double omega = speed_at(strength);
  return with(Scene{}, set::mass(2), set::wall_upper(infinity), set::restitution(e),
              set::pull(2 * gravity), set::centrifugal_mass_radius(2 * amplitude),
              set::omega(omega),
              set::phase(std::acos(fold_strength(e) / strength) - std::numbers::pi / 2),
              set::start(0, e / (1 + e) * gravity * 2 * std::numbers::pi / omega));
}

}  // namespace shaken_table

}  // namespace ricochet::carrier_track
