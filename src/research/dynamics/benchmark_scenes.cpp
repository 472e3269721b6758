#include <fmt/format.h>

#include <numbers>
#include <stdexcept>

#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/problems/default_machine.h"
#include "src/research/dynamics/work.h"

namespace ricochet::studies::dynamics {
namespace {

using namespace carrier_track;

/// A free mass of 1 kg in a gap [m] that is shaken at 10 Hz with 0.2 mm, in the gap's frame.
Scene shaken_gap(double gap, double restitution, double seconds) {
  const double amplitude = 2e-4;                         // [m]
  const double frequency = 2 * std::numbers::pi * 10.0;  // [rad/s]
  Scene scene;
  scene.wall_upper = gap;
  scene.restitution_lower = scene.restitution_upper = restitution;
  scene.disturbance = amplitude * frequency * frequency;
  scene.disturbance_frequency = frequency;
  scene.start_position = 0.5 * gap;
  scene.start_velocity = 0.03;
  scene.window = Seconds{seconds};
  return scene;
}

/// The same in a smaller gap, with higher restitution, and pulled to the lower wall with half the
/// amplitude of the shaking force.
Scene chaotic(double seconds) {
  Scene scene = shaken_gap(0.6e-3, 0.8, seconds);
  scene.pull = 0.5 * scene.disturbance;
  return scene;
}

/// A free mass of 1 kg that swings by 2 mm from one summit to the next; the first summit is 10 nm
/// beyond the upper wall. The energy lost there lets it sink to the lower wall, which it touches
/// too.
Scene grazing() {
  const double swing = 2e-3;      // [m]
  const double overshoot = 1e-8;  // [m]
  const double frequency = 10;    // [rad/s]
  const double clearance = 1e-4;  // [m]
  Scene scene;
  scene.start_position = clearance;
  scene.wall_upper = clearance + swing - overshoot;
  scene.restitution_lower = scene.restitution_upper = 0.9;
  scene.disturbance = 0.5 * swing * frequency * frequency;
  scene.disturbance_frequency = frequency;
  scene.counting_limit = 1e-6;
  scene.window = Seconds{3};
  return scene;
}

Scene case_at(const char* id, double omega) {
  Scene scene = scene_of(find_case(id), default_machine());
  scene.omega = omega;
  return scene;
}

}  // namespace

std::vector<BenchmarkScene> benchmark_scenes(double seconds) {
  return {
      {"mild", "Mild: a shaken gap",
       "A free mass of 1 kg between walls 1 mm apart, shaken at 10 Hz by 0.2 mm, restitution 0.5, "
       "for half a second: no friction, no rest, and a motion that forgets its start.",
       shaken_gap(1e-3, 0.5, 0.5)},
      {"fast", "Fast: case C2 at 10 rad/s",
       "The paper's case C2, restitution 0.9 and friction 0.1, where the carrier hammers the "
       "track.",
       case_at("C2", 10)},
      {"sticking", "Sticking: case C3 at 9 rad/s",
       "The paper's case C3, restitution 0.1 and friction 0.4: the carrier comes to rest, in the "
       "gap or on a wall after ever smaller hops, and breaks loose again.",
       case_at("C3", 9)},
      {"grazing", "Grazing: a wall that is just touched",
       "A free mass of 1 kg that swings by 2 mm and overshoots the upper wall by 10 nm, "
       "restitution "
       "0.9, for 3 s. Slow touches count here from 1 µm/s.",
       grazing()},
      {"chaotic", "Chaotic: a shaken gap with a pull",
       fmt::format("A free mass of 1 kg between walls 0.6 mm apart, shaken at 10 Hz by 0.2 mm and "
                   "pulled to one of them with half the force of the shaking, restitution 0.8, for "
                   "{} s: after a while rounding alone decides where the body is, so only the "
                   "impacts per second are compared.",
                   seconds),
       chaotic(seconds), true}};
}

Scene benchmark_scene(const std::string& id, double seconds) {
  for (const BenchmarkScene& benchmark : benchmark_scenes(seconds)) {
    if (benchmark.id == id) return benchmark.scene;
  }
  throw std::invalid_argument("there is no scene " + id);
}

Scene stiff_gap(double stiffness) {
  Scene scene = shaken_gap(1e-3, 0.9, 0.1);
  scene.start_velocity = 0.1;
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = stiffness;
  return scene;
}

std::vector<BenchmarkScene> stiff_benchmark_scenes() {
  const auto compliant = [](const char* id, const char* name, double stiffness) {
    BenchmarkScene result{id, name, {}, shaken_gap(1e-3, 0.5, 0.5)};
    result.scene.fidelity = Fidelity::compliant;
    result.scene.contact_law = ContactLaw::exact_restitution;
    result.scene.stiffness = stiffness;
    result.scene.contact_speed = result.scene.start_velocity;
    result.description = fmt::format(
        "The mild scene on walls that give way, with {:.0e} N/m^1.5, and straight through the "
        "contacts: these methods know no impact, only a force that is there behind a wall. Its "
        "damping is scaled with one speed, {} m/s, so that it depends on the state alone. The "
        "reference lands on both edges of every contact.",
        stiffness, *result.scene.contact_speed);
    return result;
  };
  return {compliant("stiff", "Stiff: a shaken gap with walls that give way", 1e12),
          compliant("very-stiff", "Very stiff: the same, ten thousand times stiffer", 1e16)};
}

}  // namespace ricochet::studies::dynamics
