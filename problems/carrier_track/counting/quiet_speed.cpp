#include "problems/carrier_track/counting/quiet_speed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"
#include "ricochet/random.h"
#include "src/core/in_parallel.h"

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
  const auto louder = std::find_if(answer.regimes.begin(), answer.regimes.end(), is_louder);
  if (louder == answer.regimes.end()) {
    if (!answer.reached) answer.fastest_quiet = options.fastest;
    return answer;
  }
  answer.split.first_loud = louder->from;
  if (louder == answer.regimes.begin()) {
    answer.loud_everywhere =
        !answer.reached && std::all_of(louder, answer.regimes.end(), is_louder);
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

namespace ricochet::carrier_track::inline answer {

namespace {

/// Calls use(key, member...) for every constant that may deviate in manufacture.
template <class Use>
class EachConstant {
 public:
  EachConstant(std::string prefix, const Use& use) : prefix_(std::move(prefix)), use_(use) {}

  template <class T>
  void operator()(const SceneField& field, T&& member) const {
    if constexpr (std::is_same_v<std::remove_cvref_t<T>, double>) {
      if (field.perturbation == Perturbation::relative)
        use_(prefix_ + std::string(field.key), member);
    }
  }
  void operator()(const SceneField& field, Walls<double> walls) const {
    if (field.perturbation != Perturbation::restitution) return;
    use_(prefix_ + std::string(field.key), walls.lower);
    use_(prefix_ + std::string(field.key), walls.upper);
    walls.lower = std::min(1.0, walls.lower);
    walls.upper = std::min(1.0, walls.upper);
  }
  void operator()(const SceneField& field, std::optional<double>& member) const {
    if (member) (*this)(field, *member);
  }
  template <class Knots>
  void operator()(const SceneField&, PlateSpeed<double, Knots>) const {}

 private:
  std::string prefix_;
  const Use& use_;
};

/// Calls use(key, clearance) for the walls of x or of y, and moves the upper wall to the result.
template <class Owner, class Use>
void visit_clearance(Owner& owner, const std::string& key, const Use& use) {
  if (!std::isfinite(owner.wall_upper)) return;
  double clearance = owner.wall_upper - owner.wall_lower;
  const double share = (owner.start_position - owner.wall_lower) / clearance;
  const double before = clearance;
  use(key, clearance);
  if (clearance == before) return;  // keeps all digits
  owner.wall_upper = owner.wall_lower + clearance;
  owner.start_position = std::min(owner.wall_upper, owner.wall_lower + share * clearance);
}

constexpr const char* counting_limit = "counting_limit";

/// The constants and, where impacts count, the counting limit.
template <class Use>
void visit_constants(Scene& scene, const Use& use) {
  visit_scene_fields(EachConstant("", use), scene);
  if (scene.fidelity == Fidelity::compliant || scene.fidelity == Fidelity::automatic) {
    visit_model_fields(EachConstant("", use), scene);
  }
  visit_clearance(scene, "clearance", use);
  if (scene.rule == CountRule::impacts) use(counting_limit, scene.counting_limit);
  if (!scene.across) return;
  visit_across_fields(EachConstant("across.", use), *scene.across);
  visit_clearance(*scene.across, "across.clearance", use);
}

/// The sum over the walls of what has a value for each, of which one may be 0.
double value_of(Scene scene, const std::string& wanted) {
  double value = 0;
  visit_constants(scene, [&](const std::string& key, double x) {
    if (key == wanted) value += x;
  });
  return value;
}

/// The speed that best divides the speeds low, low ratio, low ratio^2, ... by the limit.
std::optional<double> divide(const Scene& scene, const Limit& limit, double low, double ratio,
                             int speeds) {
  std::vector<double> at;
  for (int k = 0; k < speeds; ++k) at.push_back(low * std::pow(ratio, k));
  SpeedScan scan{1, {}};
  for (const double measure : measured_at(scene, limit.measure, at)) {
    scan.counts.push_back(measure > limit.at_most ? 1 : 0);
  }
  const auto place = best_split(scan, 0.5).speed;  // k + 1.5 between the speeds k and k + 1
  return place ? std::optional(low * std::pow(ratio, *place - 1)) : std::nullopt;
}

}  // namespace

void check_near(const Scene& scene, double omega, int machines) {
  check(scene, "scene");
  if (!(omega > 0 && omega <= fastest_frequency)) {
    throw InputError(
        fmt::format("omega = {}: must be > 0 and at most {} [rad/s]", omega, fastest_frequency));
  }
  if (machines < 1) throw InputError(fmt::format("machines = {}: must be >= 1", machines));
}

std::vector<std::string> constants_of(const Scene& scene) {
  std::vector<std::string> keys;
  Scene copy = scene;
  visit_constants(copy, [&](const std::string& key, double x) {
    const bool known = !keys.empty() && keys.back() == key;
    if (x != 0 && !known && key != counting_limit) keys.push_back(key);
  });
  return keys;
}

Scene scaled(Scene scene, const std::string& wanted, double factor) {
  visit_constants(scene, [&](const std::string& key, double& x) {
    if (key == wanted) x *= factor;
  });
  return scene;
}

std::optional<double> divide_near(const Scene& scene, const Limit& limit, double omega) {
  if (is_of_the_long_run(scene, limit)) {
    const double highest = omega * 1.5;
    const auto speed = quiet_up_to(scene, limit.at_most, {omega / 1.5, highest});
    return speed && *speed < highest ? speed : std::nullopt;
  }
  constexpr double coarse = 1.002;
  const int speeds = 1 + static_cast<int>(std::lround(std::log(2.25) / std::log(coarse)));
  const auto first = divide(scene, limit, omega / 1.5, coarse, speeds);
  if (!first) return std::nullopt;
  constexpr int fine = 100;
  const double ratio = std::pow(coarse, 2.0 / fine);
  return divide(scene, limit, *first / coarse, ratio, fine + 1).value_or(*first);
}

std::vector<Sensitivity> sensitivities(const Scene& scene, const Limit& limit, double omega) {
  check_near(scene, omega);
  constexpr double percent = 0.01;
  std::vector<std::string> keys = constants_of(scene);
  if (scene.rule == CountRule::impacts) keys.emplace_back(counting_limit);
  std::vector<std::optional<double>> divides(2 * keys.size());
  in_parallel("sensitivities", divides.size(), [&](std::size_t i) {
    const double factor = i % 2 == 0 ? 1 - percent : 1 + percent;
    divides[i] = divide_near(scaled(scene, keys[i / 2], factor), limit, omega);
  });
  std::vector<Sensitivity> result;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const auto& less = divides[2 * k];
    const auto& more = divides[2 * k + 1];
    if (!less || !more) continue;
    const double change = std::log(value_of(scaled(scene, keys[k], 1 + percent), keys[k]) /
                                   value_of(scaled(scene, keys[k], 1 - percent), keys[k]));
    result.push_back({keys[k], std::log(*more / *less) / change});
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return std::abs(a.percent) > std::abs(b.percent);
  });
  return result;
}

std::optional<ToleranceRange> divide_range(const std::vector<Scene>& machines, const Limit& limit,
                                           double omega) {
  std::vector<std::optional<double>> divides(machines.size());
  in_parallel("machines within the tolerance", machines.size(),
              [&](std::size_t i) { divides[i] = divide_near(machines[i], limit, omega); });
  const int all = static_cast<int>(machines.size());
  ToleranceRange range{std::numeric_limits<double>::infinity(), 0, all, 0};
  for (const std::optional<double>& speed : divides) {
    if (!speed) {
      ++range.without;
      continue;
    }
    range.lowest = std::min(range.lowest, *speed);
    range.highest = std::max(range.highest, *speed);
  }
  return range.without < all ? std::optional(range) : std::nullopt;
}

std::optional<ToleranceRange> tolerance_range(const Scene& scene, const Limit& limit, double omega,
                                              double tolerance, int machines, std::uint64_t seed) {
  check_near(scene, omega, machines);
  if (!(tolerance >= 0 && tolerance <= 0.5)) {
    throw InputError(fmt::format("tolerance = {}: must be within 0..0.5", tolerance));
  }
  const std::vector<std::string> keys = constants_of(scene);
  Random random(seed);
  std::vector<Scene> drawn;
  for (int i = 0; i < machines; ++i) {
    Scene& machine = drawn.emplace_back(scene);
    for (const std::string& key : keys) {
      machine = scaled(std::move(machine), key, 1 + tolerance * (2 * uniform(random) - 1));
    }
  }
  return divide_range(drawn, limit, omega);
}

std::optional<UncertainDivide> uncertain_divide(const SceneFile& file, const Limit& limit,
                                                double omega, int machines, std::uint64_t seed) {
  const std::size_t numbers = file.uncertainties.size();
  if (numbers == 0) return std::nullopt;
  check_near(file.scene, omega, machines);
  Random random(seed);
  std::vector<Scene> drawn;
  std::vector<double> shares(numbers);
  for (int i = 0; i < machines; ++i) {
    for (double& share : shares) share = 2 * uniform(random) - 1;
    drawn.push_back(file.at(shares));
  }
  const std::optional<ToleranceRange> range = divide_range(drawn, limit, omega);
  if (!range) return std::nullopt;
  std::vector<std::optional<double>> divides(2 * numbers);
  in_parallel("uncertainties", divides.size(), [&](std::size_t i) {
    std::vector<double> one(numbers, 0);
    one[i / 2] = i % 2 == 0 ? -1 : 1;
    divides[i] = divide_near(file.at(one), limit, omega);
  });
  UncertainDivide result{{}, 0, *range};
  for (std::size_t k = 0; k < numbers; ++k) {
    const auto& below = divides[2 * k];
    const auto& above = divides[2 * k + 1];
    if (!below || !above) continue;
    const double change = (*above - *below) / 2;
    result.effects.push_back({file.uncertainties[k].key, change});
    result.first_order += std::abs(change);
  }
  std::stable_sort(result.effects.begin(), result.effects.end(), [](const auto& a, const auto& b) {
    return std::abs(a.change) > std::abs(b.change);
  });
  return result;
}

}  // namespace ricochet::carrier_track::inline answer
