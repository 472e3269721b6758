#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/answer/long_run.h"
#include "problems/carrier_track/counting/complete_scan.h"
#include "problems/carrier_track/counting/counts.h"
#include "problems/carrier_track/counting/limit.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/window.h"
#include "ricochet/error.h"
#include "ricochet/recording.h"
#include "ricochet/threshold.h"

namespace ricochet::carrier_track::inline counting {
namespace {

constexpr double slowest_of_a_range = 0.01;  // [rad/s]

/// The step located between two neighbours of the fine scan, with its first loud speed.
Step located(Step step, const SpeedScan& fine) {
  const auto speeds = static_cast<double>(fine.counts.size());
  const auto index = [&](double omega) {
    return static_cast<std::ptrdiff_t>(std::clamp(std::round(omega / fine.step) - 1, 0.0, speeds));
  };
  // The coarse scan has located it between two speeds that differ by 0.2 %.
  const std::ptrdiff_t begin = index(step.omega * 0.99);
  const std::ptrdiff_t end = index(step.omega * 1.01 + fine.step);
  const SpeedScan near{fine.step, {fine.counts.begin() + begin, fine.counts.begin() + end}};
  if (const auto speed = best_split(near, step.limit()).speed) {
    step.omega = *speed + fine.step * static_cast<double>(begin);
  }
  step.first_loud = best_split(fine, step.limit()).first_loud;
  return step;
}

/// The loud piece that scan_completely() finds below the first loud speed of the fine scan.
std::optional<CountPiece> stepped_over(const Scene& scene, const QuietSpeedOptions& options,
                                       double limit, double first_loud) {
  const double last = first_loud - options.step;  // the last speed known to be quiet
  if (!suits_lanes(at_speed(scene, last)) || !(last > options.step)) return std::nullopt;
  const auto scan = scan_completely(scene, options.step, last);
  return scan ? scan->first_above(limit) : std::nullopt;
}

CountThere count_there(const Scene& scene, double omega) {
  const Scene there = at_speed(scene, omega);
  const Recording recording = record(there, 0, 0);
  return {omega, recording.count, recording.count / turns_of(there), recording.certainty.certain,
          recording.certainty.reason};
}

void check(const QuietSpeedOptions& options) {
  const auto within = [](const char* name, double x, double lowest, double highest) {
    if (x >= lowest && x <= highest) return;
    throw InputError(
        fmt::format("{} = {}: must be within {}..{} [rad/s]", name, x, lowest, highest));
  };
  within("fastest", options.fastest, shortest_range, longest_range);
  within("step", options.step, options.fastest * 1e-7, options.fastest / 10);
  if (options.limit && !(options.limit->at_most >= 0 && std::isfinite(options.limit->at_most))) {
    throw InputError(fmt::format("limit = {}: must be finite and >= 0", options.limit->at_most));
  }
}

/// The answer by a limit of the collisions in a window, or of what else is measured in it.
QuietSpeed quiet_in_the_window(const Scene& scene, const QuietSpeedOptions& options) {
  QuietSpeed answer;
  answer.options = options;
  answer.scan = scan_logarithmically(scene, slowest_scanned, judged_share * options.fastest);
  answer.staircase = staircase_of(answer.scan, options.fastest);
  answer.fine = scan_speeds(scene, options.step, options.fastest);
  for (Step& step : answer.staircase.steps) step = located(step, answer.fine);
  answer.limit = options.limit;
  if (options.limit) {
    answer.split = options.limit->measure == Measure::collisions
                       ? best_split(answer.fine, options.limit->at_most)
                       : split_by(scene, *options.limit, options.step, options.fastest);
  } else if (const auto main = answer.staircase.main_step()) {
    answer.limit = {Measure::collisions, std::floor(main->limit())};
    answer.split = best_split(answer.fine, main->limit());
    answer.split.speed = main->omega;  // from the speeds around it, not from the range
  }
  if (!answer.limit) return answer;
  // A range without a loud speed is quiet up to its end.
  double loud = answer.split.first_loud.value_or(options.fastest + options.step);
  if (answer.limit->measure == Measure::collisions) {
    const double limit =
        options.limit ? options.limit->at_most : answer.staircase.main_step()->limit();
    answer.stepped_over = stepped_over(scene, options, limit, loud);
  }
  if (answer.stepped_over) {
    answer.split.first_loud = answer.stepped_over->from;
    loud = std::ceil(answer.stepped_over->from / options.step) * options.step;
  }
  if (loud > 1.5 * options.step) answer.fastest_quiet = loud - options.step;
  const double at = answer.fastest_quiet.value_or(loud);
  for (const double omega : {at - options.step, at, at + options.step}) {
    if (omega > options.step / 2) answer.around.push_back(count_there(scene, omega));
  }
  return answer;
}

/// The answer by a limit of the collisions in a turn, in the long run.
QuietSpeed quiet_in_the_long_run(const Scene& scene, const QuietSpeedOptions& options,
                                 const Limit& limit) {
  QuietSpeed answer;
  answer.options = options;
  answer.limit = limit;
  answer.regimes = regimes_of(scene, {slowest_of_a_range, options.fastest});
  const auto louder =
      std::find_if(answer.regimes.begin(), answer.regimes.end(),
                   [&](const Regime& regime) { return regime.most_per_turn > limit.at_most; });
  if (louder == answer.regimes.end()) {
    answer.fastest_quiet = options.fastest;
    return answer;
  }
  answer.split.speed = answer.split.first_loud = louder->from;
  const double steps = std::ceil(louder->from / options.step) - 1;
  if (steps >= 1) answer.fastest_quiet = steps * options.step;
  return answer;
}

}  // namespace

QuietSpeed quiet_speed(const Scene& scene, const QuietSpeedOptions& options) {
  check(scene, "scene");
  check_constant_speed(scene, "scene");
  check(options);
  const Limit limit = options.limit.value_or(Limit{Measure::collisions_per_turn, quiet_per_turn});
  return is_of_the_long_run(scene, limit) ? quiet_in_the_long_run(scene, options, limit)
                                          : quiet_in_the_window(scene, options);
}

}  // namespace ricochet::carrier_track::inline counting
