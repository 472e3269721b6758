#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"
#include "ricochet/random.h"
#include "solvers/library_solvers.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "src/studies/best_values/best_values.h"

namespace ricochet::studies::best_values {

namespace {

using namespace carrier_track;

constexpr double finest_step = 1e-4;  // [rad/s]
constexpr double bisected_to = 1e-7;
constexpr double least_share = 1e-3;  // of the box, in the last quiet interval
constexpr double largest_share = 1e-2;
constexpr double least_distance = 0.5;  // [rad/s]
constexpr double least_loud = 0.1;
constexpr double fastest_best = 17.9;
constexpr double largest_bisection_share = 0.25;
constexpr int most_around_a_case = 5;

struct LastQuietInterval {
  QuietInterval quiet_interval;
  Hardness hardness;
};

/// Returns the last quiet interval and the quiet speeds below it, if a scan finds the machine hard;
/// `slack` is the possible error of a coarse scan.
std::optional<LastQuietInterval> last_quiet_interval(const Machine& machine, double step,
                                                     double slack) {
  const std::vector<QuietInterval> found =
      quiet_intervals(scan_speeds(machine.scene, step, fastest_speed), machine.quiet_limit);
  if (found.size() < 2) return std::nullopt;
  const QuietInterval& last = found.back();
  Hardness hardness;
  for (const QuietInterval& one : found) {
    if (one.width() < speed_tolerance - slack) continue;
    if (hardness.quiet_intervals++ == 0) hardness.first_end = one.to;
  }
  hardness.last_begin = last.from;
  hardness.loud_before = last.from - found[found.size() - 2].to;
  const double box = fastest_speed - slowest_speed;
  const bool hard = hardness.quiet_intervals > 1 && last.width() >= least_share * box - slack &&
                    last.width() <= largest_share * box + slack &&
                    last.to - hardness.first_end >= least_distance - slack &&
                    hardness.loud_before >= least_loud - slack && last.to < fastest_best;
  return hard ? std::optional(LastQuietInterval{last, hardness}) : std::nullopt;
}

/// The end of the quiet interval [rad/s], to bisected_to: between a quiet speed and a loud one.
double end_of(const Machine& machine, double quiet, double loud) {
  while (loud - quiet > bisected_to) {
    const double middle = (quiet + loud) / 2;
    (count_at(machine.scene, middle) <= machine.quiet_limit ? quiet : loud) = middle;
  }
  return quiet;
}

bool is_certain(const Machine& machine, double speed) {
  return record(at_speed(machine.scene, speed), default_smoothing, 0).certainty.certain;
}

/// Returns true if bisection misses the best speed from the middle, which is also its continuation
/// from an end, and from most starts. Records its error from the middle, and the share of starts
/// from which it succeeds.
bool bisection_misses(const Machine& machine, double best, Hardness& hardness) {
  const Problem problem = top_speed_problem(machine);
  constexpr int parts = 256;
  int solved = 0;
  for (int k = 1; k < parts; ++k) {
    Evaluator evaluator(problem, Budget{100});
    Random unused;
    const Vector start =
        problem.lower + static_cast<double>(k) / parts * (problem.upper - problem.lower);
    const double gap =
        best - bisection().solve(evaluator, start, unused).point.value_or(problem.upper)[0];
    if (k == parts / 2) {
      if (gap <= speed_tolerance) return false;
      hardness.bisection_gap = gap;
    }
    solved += gap <= speed_tolerance ? 1 : 0;
  }
  hardness.bisection_share = static_cast<double>(solved) / (parts - 1);
  return hardness.bisection_share <= largest_bisection_share;
}

}  // namespace

Machine random_machine(const Scene& constants, const std::string& around, int draw) {
  Random random(seed_of(around, "hard machine", draw, 0));
  const auto between = [&random](double low, double high) {
    return low * std::pow(high / low, uniform(random));
  };
  Machine machine;
  machine.id = fmt::format("{}~{}", around, draw);
  Scene& scene = machine.scene;
  scene = scene_of(find_case(around), constants);
  for (const std::string& key : constants_of(scene)) {
    scene = scaled(std::move(scene), key, between(0.5, 2));
  }
  scene.disturbance = between(0.1, 100);
  scene.disturbance_frequency = between(1, 100);
  scene.disturbance_phase = 2 * std::numbers::pi * uniform(random);
  scene.phase = 2 * std::numbers::pi * uniform(random);
  machine.quiet_limit = quiet_limit(quiet_count(scene, Claim{}, ScanOptions{}));
  return machine;
}

std::optional<HardMachine> judged_hard(const Machine& machine) {
  for (const double coarse : {1e-2, 1e-3}) {
    if (!last_quiet_interval(machine, coarse, 2 * coarse)) return std::nullopt;
  }
  const auto last = last_quiet_interval(machine, finest_step, 0);
  if (!last) return std::nullopt;
  const double best =
      end_of(machine, last->quiet_interval.to, last->quiet_interval.to + finest_step);
  for (const double at : {best - finest_step, best, best + finest_step})
    if (!is_certain(machine, at)) return std::nullopt;
  HardMachine hard;
  hard.hardness = last->hardness;
  if (!bisection_misses(machine, best, hard.hardness)) return std::nullopt;
  hard.machine = machine;
  hard.best = {-best, Vector::Constant(1, best),
               fmt::format("exhaustive scan, step {}, then bisection to {}; count certain",
                           finest_step, bisected_to)};
  return hard;
}

HardMachines find_hard_machines(int draws, std::size_t wanted) {
  const std::vector<Case> cases = all_cases();
  const std::size_t size = cases.size() * static_cast<std::size_t>(draws);
  std::vector<std::optional<HardMachine>> judged(size);
  {
    Progress progress("looking for hard machines", static_cast<double>(size));
    tbb::parallel_for(std::size_t{0}, size, [&](std::size_t i) {
      const std::string& around = cases[i % cases.size()].id;
      const int draw = static_cast<int>(i / cases.size());
      judged[i] = judged_hard(random_machine(default_machine(), around, draw));
      if (judged[i]) {
        judged[i]->around = around;
        judged[i]->draw = draw;
      }
      progress.advance(1);
    });
  }
  std::vector<HardMachine> found;
  for (std::optional<HardMachine>& hard : judged) {
    if (hard) found.push_back(std::move(*hard));
  }
  std::stable_sort(found.begin(), found.end(), [](const HardMachine& a, const HardMachine& b) {
    return quiet_interval_share(a) < quiet_interval_share(b);
  });
  std::map<std::string, int> around;
  std::vector<HardMachine> kept;
  for (HardMachine& hard : found) {
    if (kept.size() == wanted) break;
    if (++around[hard.around] > most_around_a_case) continue;
    hard.machine.id = fmt::format("{:02}", kept.size() + 1);
    kept.push_back(std::move(hard));
  }
  return {default_machine(), std::move(kept)};
}

}  // namespace ricochet::studies::best_values
