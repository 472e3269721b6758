#include "src/research/long_run/per_turn.h"

#include <numbers>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/models/impact_model.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/regimes/steady_motion.h"

namespace ricochet::studies::long_run {
namespace {

using namespace carrier_track;

constexpr int before = 1, observed = 1;  // turns
constexpr int phases = 8;                // of a disturbance
// Share of the counting limit: a body that rebounds slower rests. It would rest before the next
// throw, without another collision that counts.
constexpr double resting_share = 0.5;

/// Counts the collisions from a time on; throws TooMany.
struct LateCount : Observer {
  [[maybe_unused]] static constexpr bool hears_impacts_alone = true;
  struct TooMany {};

  double from;   // [s]
  double limit;  // [m/s]
  int most;
  int all = 0;
  int late = 0;

  LateCount(double start, double counting_limit, int stop)
      : from(start), limit(counting_limit), most(stop) {}

  void impact(double time, Wall /*wall*/, double speed) {
    if (!is_counted(speed, limit)) return;
    if (++all > most) throw TooMany();
    if (time >= from) ++late;
  }
};

}  // namespace

double collisions_per_turn(const Scene& scene) {
  Scene machine = scene;
  machine.fidelity = Fidelity::impact;
  if (!is_disturbed(machine)) return steady_motion(machine).collisions_per_turn();
  DisturbedMotion motion = disturbed_motion(machine);
  if (!motion.settled) observe(motion);
  double sum = 0;
  for (const DisturbedTurn& turn : motion.turns) sum += turn.collisions;
  return sum / static_cast<double>(motion.turns.size());
}

double brief_collisions_per_turn(const Scene& scene, int most) {
  constexpr double circle = 2 * std::numbers::pi;
  Scene machine = scene;
  machine.start_position = scene.wall_lower;
  machine.start_velocity = 0;
  machine.window = Revolutions{before + observed};
  const int tries = is_disturbed(scene) ? phases : 1;
  int collisions = 0;
  for (int k = 0; k < tries; ++k) {
    machine.disturbance_phase = circle * k / tries;
    LateCount count(before * circle / scene.omega, scene.counting_limit,
                    most * (before + observed));
    try {
      ImpactModel<double>(machine, resting_share * scene.counting_limit).run(count);
    } catch (const LateCount::TooMany&) {
      return most + 1;
    }
    collisions += count.late;
  }
  return static_cast<double>(collisions) / (tries * observed);
}

}  // namespace ricochet::studies::long_run
