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
    const double omega = scene.omega;
    return counts_at(scene, std::span(&omega, 1)).front();
  } catch (const std::runtime_error&) {
    return quiet_nan;
  }
}

/// What `get` makes of each of the items, one after the other.
template <class Items, class Get>
Numbers joined(const Items& items, const Get& get, Numbers numbers = {}) {
  for (const auto& item : items)
    for (const double x : get(item)) numbers.push_back(x);
  return numbers;
}

Numbers impacts_of(const Scene& scene, double omega) {
  const Recording recording = record(at_speed(scene, omega), 0, 0);
  return joined(recording.impacts,
                [](const Impact& one) {
                  return Numbers{one.time, one.speed};
                },
                {static_cast<double>(recording.count)});
}

Numbers regimes_as_numbers(const Scene& scene) {
  return joined(regimes_of(scene), [](const Regime& regime) {
    return Numbers{regime.from, regime.to, regime.most_per_turn};
  });
}

Numbers rule_of(const Scene& scene, const Claim& claim, const SpeedScan& scan) {
  const Score found = score(scene, Claim{claim.threshold, {}, {}}, scan, 1);
  return {static_cast<double>(found.quiet_count), found.threshold.value_or(quiet_nan),
          found.first_loud.value_or(quiet_nan), found.misclassified};
}

Numbers race_of(const Machine& machine, live::Racer racer) {
  const live::Race race{machine.scene, machine.quiet_limit, 18, 100};
  return joined(live::steps_of(racer, race, 7), [](const live::RaceStep& one) {
    return Numbers{one.omega, static_cast<double>(one.count)};
  });
}

/// The border of two collisions a turn, the most collisions below it in the window, and what moves
/// it.
Numbers sensitivities_of(const Scene& scene) {
  const double border = quiet_up_to(scene, quiet_per_turn, {0.01, 18}).value_or(quiet_nan);
  const Limit limit{Measure::collisions_per_turn, quiet_per_turn};
  return joined(sensitivities(scene, limit, border),
                [](const Sensitivity& one) { return Numbers{one.percent}; },
                {border, static_cast<double>(most_collisions_below(scene, border, 1e-3))});
}

class File {
 public:
  explicit File(const char* name) : stream_(name, std::ios::binary) {}

  void add(const Numbers& numbers) {
    stream_.write(reinterpret_cast<const char*>(numbers.data()),
                  static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  }
  void add_list(const Numbers& numbers) {
    add({static_cast<double>(numbers.size())});
    add(numbers);
  }
  bool close() {
    stream_.close();
    return !stream_.fail();
  }

 private:
  std::ofstream stream_;
};

void add_case(File& file, const Machine& machine) {
  file.add(live::numbers_of(machine.scene));
  SpeedScan scan{step, {}};
  Numbers scanned;
  for (std::size_t k = 0; k < speeds; ++k) scanned.push_back(scan.omega(k));
  scan.counts = counts_at(machine.scene, scanned);
  file.add_list({scan.counts.begin(), scan.counts.end()});
  file.add_list(impacts_of(machine.scene, 9));
  file.add_list(regimes_as_numbers(machine.scene));
  Claim claim;
  claim.threshold = machine.threshold;
  file.add_list(rule_of(machine.scene, claim, scan));
  for (const auto racer :
       {live::Racer::fireworks, live::Racer::random_search, live::Racer::bisection}) {
    file.add_list(race_of(machine, racer));
  }
  file.add_list({live::goal_of({machine.scene, machine.quiet_limit, 18}).value_or(quiet_nan)});
  file.add_list(sensitivities_of(machine.scene));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const int number = std::atoi(argv[1]);
  File file(argv[2]);
  RandomScenes random(2024);
  file.add({static_cast<double>(live::numbers_of(Scene{}).size()), static_cast<double>(number)});
  for (int k = 0; k < number; ++k) {
    const Scene scene = random.next();
    Numbers numbers = live::numbers_of(scene);
    numbers.push_back(count_of(scene));
    file.add(numbers);
  }
  const std::vector<Machine> machines = all_machines();
  for (std::size_t k = 0; k < 4; ++k) add_case(file, machines[k]);
  return file.close() ? 0 : 1;
}
