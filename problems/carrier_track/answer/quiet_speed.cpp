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
#include "ricochet/time_limit.h"

namespace ricochet::carrier_track::inline counting {
namespace {

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

/// The split of the speeds that were scanned; one of all speeds has also the speed that divides
/// them best.
Split split_of(QuietSpeed& answer, const SpeedScan& scan, double limit) {
  Split split = best_split(scan, limit);
  answer.loud_everywhere = !split.speed && split.first_loud == scan.omega(0);
  if (extends_to(scan, answer.options.fastest)) return split;
  answer.reached = scan.step * static_cast<double>(scan.counts.size());
  return {{}, split.first_loud, 0};
}

/// Divides the speeds by the limit of the window, given or by the staircase.
void divide_window(QuietSpeed& answer, const Scene& scene) {
  const QuietSpeedOptions& options = answer.options;
  answer.fine = scan_slowest_speeds(scene, options.step, options.fastest);
  if (answer.fine.counts.empty()) throw TimeLimitReached();
  if (options.limit) {
    answer.limit = options.limit;
    answer.split =
        options.limit->measure == Measure::collisions
            ? split_of(answer, answer.fine, options.limit->at_most)
            : split_of(answer, scan_by(scene, *options.limit, options.step, options.fastest), 0.5);
  }
  if (!extends_to(answer.fine, options.fastest)) {
    answer.reached = options.step * static_cast<double>(answer.fine.counts.size());
    return;
  }
  answer.scan = scan_logarithmically(scene, slowest_scanned, judged_share * options.fastest);
  answer.staircase = staircase_of(answer.scan, options.fastest);
  for (Step& step : answer.staircase.steps) step = located(step, answer.fine);
  if (options.limit) return;
  if (const auto main = answer.staircase.main_step()) {
    answer.limit = {Measure::collisions, std::floor(main->limit())};
    answer.split = split_of(answer, answer.fine, main->limit());
    answer.split.speed = main->omega;  // from the speeds around it, not from the range
  }
}

/// The answer by a limit of the collisions in a window, or of what else is measured in it.
QuietSpeed quiet_in_the_window(const Scene& scene, const QuietSpeedOptions& options) {
  QuietSpeed answer;
  answer.options = options;
  try {
    divide_window(answer, scene);
  } catch (const TimeLimitReached&) {
    if (answer.fine.counts.empty()) throw;
    answer.reached = answer.reached.value_or(options.fastest);
  }
  if (!answer.limit) return answer;
  if (answer.reached && !answer.split.first_loud) return answer;
  // A range without a loud speed is quiet up to its end.
  double loud = answer.split.first_loud.value_or(options.fastest + options.step);
  try {
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
  } catch (const TimeLimitReached&) {
    if (loud > 1.5 * options.step) answer.fastest_quiet = loud - options.step;
    answer.reached = answer.reached.value_or(options.fastest);
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
  const Regime& last = answer.regimes.back();
  if (last.ends_by == RegimeEnd::time_limit) answer.reached = last.to;
  const auto is_louder = [&](const Regime& regime) { return regime.most_per_turn > limit.at_most; };
  const auto louder = std::ranges::find_if(answer.regimes, is_louder);
  if (louder == answer.regimes.end()) {
    if (!answer.reached) answer.fastest_quiet = options.fastest;
    return answer;
  }
  answer.split.first_loud = louder->from;
  if (louder == answer.regimes.begin()) {
    answer.loud_everywhere = !answer.reached && std::ranges::all_of(answer.regimes, is_louder);
    return answer;
  }
  answer.split.speed = louder->from;
  const double steps = std::ceil(louder->from / options.step) - 1;
  if (steps * options.step >= slowest_of_a_range) answer.fastest_quiet = steps * options.step;
  return answer;
}

}  // namespace

QuietSpeed quiet_speed(const Scene& scene, const QuietSpeedOptions& options) {
  check(scene, "scene");
  check_constant_speed(scene, "scene");
  check(options);
  const Limit limit = limit_of(options);
  return is_of_the_long_run(scene, limit) ? quiet_in_the_long_run(scene, options, limit)
                                          : quiet_in_the_window(scene, options);
}

}  // namespace ricochet::carrier_track::inline counting
