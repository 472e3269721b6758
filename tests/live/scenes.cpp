// ricochet_live_scenes NUMBER FILE: what the native program makes of random machines, for
// module_test.mjs. The file has plain doubles, and begins with the numbers of a scene and NUMBER.
// For each machine: its numbers, and its count; NaN if it has more impacts than a simulation may
// have. Then for each of the paper's first four cases: its numbers, 900 counts, and the lists
// below, each with its length before it.
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/machine.h"
#include "src/live/flat_scene.h"
#include "src/live/race.h"
#include "tests/support/numbers.h"

namespace {

using namespace ricochet;
using namespace ricochet::carrier_track;

constexpr double step = 0.02;  // [rad/s], of a scan of 900 speeds
constexpr std::size_t speeds = 900;

using Numbers = std::vector<double>;

double count_of(const Scene& scene) {
  try {
    return counts_at(scene, std::span(&scene.omega, 1)).front();
  } catch (const std::runtime_error&) {
    return quiet_nan;
  }
}

void add(Numbers& all, const Numbers& numbers) {
  all.insert(all.end(), numbers.begin(), numbers.end());
}

void add_list(Numbers& all, const Numbers& numbers) {
  all.push_back(static_cast<double>(numbers.size()));
  add(all, numbers);
}

void add_case(Numbers& all, const Machine& machine) {
  const Scene& scene = machine.scene;
  add(all, live::numbers_of(scene));
  SpeedScan scan{step, {}};
  Numbers scanned;
  for (std::size_t k = 0; k < speeds; ++k) scanned.push_back(scan.omega(k));
  scan.counts = counts_at(scene, scanned);
  add_list(all, {scan.counts.begin(), scan.counts.end()});

  const Recording recording = record(at_speed(scene, 9.0), 0, 0);
  Numbers impacts = {static_cast<double>(recording.count)};
  for (const Impact& one : recording.impacts) add(impacts, {one.time, one.speed});
  add_list(all, impacts);

  Numbers regimes;
  for (const Regime& one : regimes_of(scene)) add(regimes, {one.from, one.to, one.most_per_turn});
  add_list(all, regimes);

  Claim claim;
  claim.threshold = machine.threshold;
  const Score found = score(scene, claim, scan, 1);
  add_list(all, {static_cast<double>(found.quiet_count), found.threshold.value_or(quiet_nan),
                 found.first_loud.value_or(quiet_nan), found.misclassified});

  for (const auto racer :
       {live::Racer::fireworks, live::Racer::random_search, live::Racer::bisection}) {
    Numbers race;
    for (const live::RaceStep& one :
         live::steps_of(racer, {scene, machine.quiet_limit, 18, 100}, 7)) {
      add(race, {one.omega, static_cast<double>(one.count)});
    }
    add_list(all, race);
  }
  add_list(all, {live::goal_of({scene, machine.quiet_limit, 18}).value_or(quiet_nan)});

  // The border of two collisions a turn, the most collisions below it, and what moves it.
  const double border = quiet_up_to(scene, quiet_per_turn, {0.01, 18}).value_or(quiet_nan);
  Numbers moves = {border, static_cast<double>(most_collisions_below(scene, border, 1e-3))};
  const Limit limit{Measure::collisions_per_turn, quiet_per_turn};
  for (const Sensitivity& one : sensitivities(scene, limit, border)) moves.push_back(one.percent);
  add_list(all, moves);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const int number = std::atoi(argv[1]);
  Numbers all = {static_cast<double>(live::numbers_of(Scene{}).size()),
                 static_cast<double>(number)};
  RandomScenes random(2024);
  for (int k = 0; k < number; ++k) {
    const Scene scene = random.next();
    add(all, live::numbers_of(scene));
    all.push_back(count_of(scene));
  }
  const std::vector<Machine> machines = all_machines();
  for (std::size_t k = 0; k < 4; ++k) add_case(all, machines[k]);
  std::ofstream file(argv[2], std::ios::binary);
  file.write(reinterpret_cast<const char*>(all.data()),
             static_cast<std::streamsize>(all.size() * sizeof(double)));
  file.close();
  return file ? 0 : 1;
}
