#include "src/studies/dynamics/work.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <ranges>
#include <stdexcept>

#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/machine.h"
#include "src/core/time_limit.h"

namespace ricochet::studies::dynamics {

namespace {

using namespace carrier_track;

constexpr double shortest_measurement = 5e-4;  // [s]
constexpr double longest_repeated = 0.03;      // [s]

/// `per_decade` numbers of every decade from `first` down to `last`.
std::vector<double> controls(double first, double last, int per_decade) {
  const auto count = static_cast<int>(std::lround(per_decade * std::log10(first / last)));
  std::vector<double> values;
  for (int k = 0; k <= count; ++k) {
    values.push_back(first * std::pow(10.0, -static_cast<double>(k) / per_decade));
  }
  return values;
}

struct Measured {
  Outcome outcome;
  double seconds;  // [s] of processor time per run
};

Measured measure(const Integrator& integrator, const Scene& scene, double control) {
  double start = processor_seconds();
  Measured measured{integrator.run(scene, control), 0};
  measured.seconds = std::max(processor_seconds() - start, 1e-9);
  if (measured.seconds > longest_repeated) return measured;
  const int runs =
      static_cast<int>(std::clamp(std::ceil(shortest_measurement / measured.seconds), 1.0, 1e4));
  for (int repeat = 0; repeat < 3; ++repeat) {
    start = processor_seconds();
    for (int i = 0; i < runs; ++i) integrator.run(scene, control);
    measured.seconds = std::min(measured.seconds, (processor_seconds() - start) / runs);
  }
  return measured;
}

std::optional<double> error_of(const SceneWork& work, const Trial& trial) {
  const Accuracy& accuracy = trial.accuracy;
  if (!trial.finished) return std::nullopt;
  if (work.benchmark.chaotic) {
    const int impacts = work.impacts + accuracy.count_difference;
    if (impacts == 0) return std::nullopt;
    return std::abs(impacts / work.mean_impacts - 1);
  }
  if (accuracy.missed + accuracy.spurious > 0) return std::nullopt;
  const auto& error = accuracy.impact_time_error;
  return error && std::isfinite(*error) ? error : std::nullopt;
}

void measure_spread(const Integrator& reference, SceneWork& work) {
  constexpr int starts = 32;
  double sum = 0;
  double squares = 0;
  for (int k = 1; k <= starts; ++k) {
    Scene beside = work.benchmark.scene;
    beside.start_velocity *= 1 + 1e-12 * k;
    const double impacts = collisions(beside, reference.run(beside, 0));
    sum += impacts;
    squares += impacts * impacts;
  }
  work.mean_impacts = sum / starts;
  const double variance = squares / starts - work.mean_impacts * work.mean_impacts;
  work.rate_spread = 3 * std::sqrt(std::max(variance, 0.0)) / work.mean_impacts;
}

MethodWork work_of(const Integrator& integrator, const SceneWork& scene_work,
                   const Outcome& reference, const WorkPlan& plan) {
  const Scene& scene = scene_work.benchmark.scene;
  MethodWork work{integrator.name, integrator.setting, {}};
  std::vector<double> values = {1.0};
  if (integrator.setting == "step [s]") {
    const double pause = duration_of(scene) / scene_work.impacts;  // [s] between two impacts
    values = controls(0.1 * pause, pause / plan.steps, plan.per_decade);
  } else if (integrator.setting != "none") {
    values = controls(1e-3, plan.tolerance, plan.per_decade);
  }
  for (const double control : values) {
    const Measured measured = measure(integrator, scene, control);
    const Outcome& outcome = measured.outcome;
    Trial trial{control, measured.seconds, outcome.force_evaluations, outcome.finished,
                {},      std::nullopt};
    if (outcome.finished) trial.accuracy = compare(scene, outcome, reference);
    trial.error = error_of(scene_work, trial);
    work.trials.push_back(trial);
  }
  return work;
}

}  // namespace

namespace {

std::vector<Impact> faster_than(double speed, const Outcome& outcome) {
  std::vector<Impact> chosen;
  std::copy_if(outcome.impacts.begin(), outcome.impacts.end(), std::back_inserter(chosen),
               [&](const Impact& impact) { return impact.speed > speed; });
  return chosen;
}

}  // namespace

Accuracy compare(const Scene& scene, const Outcome& outcome, const Outcome& reference) {
  Accuracy accuracy;
  const int expected = collisions(scene, reference);
  accuracy.count_difference = collisions(scene, outcome) - expected;
  accuracy.end_position_error = std::abs(outcome.end.position - reference.end.position);
  const double window = 0.5 * duration_of(scene) / std::max(expected, 1);
  const std::vector<Impact> seen = faster_than(0.5 * scene.counting_limit, outcome);
  const std::vector<Impact> real = faster_than(0.5 * scene.counting_limit, reference);
  auto s = seen.begin();
  auto r = real.begin();
  while (s != seen.end() || r != real.end()) {
    const bool both = s != seen.end() && r != real.end();
    if (both && s->wall == r->wall && std::abs(s->time - r->time) <= window) {
      if (accuracy.missed + accuracy.spurious == 0) {
        ++accuracy.matched;
        accuracy.impact_time_error =
            std::max(accuracy.impact_time_error.value_or(0.0), std::abs(s->time - r->time));
      }
      ++s;
      ++r;
    } else if (r == real.end() || (both && s->time < r->time)) {
      accuracy.spurious += (s++)->speed > scene.counting_limit;
    } else {
      accuracy.missed += (r++)->speed > scene.counting_limit;
    }
  }
  return accuracy;
}

std::vector<Integrator> between_hard_walls() {
  std::vector<Integrator> chosen = carrier_track::all_integrators();
  std::erase_if(chosen, [](const Integrator& i) { return i.setting == carrier_track::by_depth; });
  return chosen;
}

std::vector<Integrator> through_walls() {
  std::vector<Integrator> chosen = carrier_track::all_integrators();
  std::erase_if(chosen, [](const Integrator& i) { return !i.takes_compliant; });
  return chosen;
}

SceneWork work_in(const BenchmarkScene& benchmark, const WorkPlan& plan,
                  const std::vector<Integrator>& integrators, const std::function<void()>& done) {
  const Integrator& first = integrators.front();
  const Outcome reference = first.run(benchmark.scene, 0);
  SceneWork work;
  work.benchmark = benchmark;
  work.impacts = std::max(collisions(benchmark.scene, reference), 1);
  if (benchmark.chaotic) measure_spread(first, work);
  for (const Integrator& integrator : integrators) {
    work.methods.push_back(work_of(integrator, work, reference, plan));
    done();
  }
  return work;
}

std::optional<Trial> loosest_within(const MethodWork& method, double limit) {
  std::optional<Trial> loosest;
  for (auto trial = method.trials.rbegin(); trial != method.trials.rend(); ++trial) {
    if (!trial->error || *trial->error > limit) break;
    loosest = *trial;
  }
  return loosest;
}

namespace {

using report::Chart;
using report::Direction;
using report::Mark;
using report::Scale;
using report::Series;

constexpr std::size_t named_every = 6;  ///< dots with their tolerance or step beside them

/// Limits of the error: in a chaotic scene of the rate, else of impact times [s].
std::vector<double> limits_of(const SceneWork& work) {
  if (work.benchmark.chaotic) return {work.rate_spread};
  return {1e-6, 1e-9};
}

/// Time of the loosest trial within a limit relative to the reference.
std::optional<double> slowdown(const SceneWork& work, const MethodWork& method, double limit) {
  const auto trial = loosest_within(method, limit);
  if (!trial) return std::nullopt;
  return trial->seconds / work.methods.front().trials.front().seconds;
}

/// The same for the evaluations of the forces.
std::optional<double> evaluations_ratio(const SceneWork& work, const MethodWork& method,
                                        double limit) {
  const auto trial = loosest_within(method, limit);
  const auto own = work.methods.front().trials.front().force_evaluations;
  if (!trial || own == 0) return std::nullopt;
  return static_cast<double>(trial->force_evaluations) / static_cast<double>(own);
}

/// Smallest error that is drawn: the rounding of a time, or half an impact in the rate.
double smallest_error(const SceneWork& work) {
  return work.benchmark.chaotic ? 0.5 / work.impacts : 1e-16;
}

double cost_of(const SceneWork& work, const Trial& trial) {
  return trial.seconds / work.impacts;
}

/// From the decade below the smallest error to the decade above the largest, where failures are
/// drawn.
report::Range errors_of(const SceneWork& work) {
  report::Range range{1e-3, 1e-3};
  for (const MethodWork& method : work.methods) {
    for (const Trial& trial : method.trials) {
      if (!trial.error || method.control == "none") continue;
      const double error = std::max(*trial.error, smallest_error(work));
      range = {std::min(range.lower, error), std::max(range.upper, error)};
    }
  }
  return {std::pow(10, std::floor(std::log10(range.lower))),
          std::pow(10, std::ceil(std::log10(range.upper)) + 1)};
}

/// A tolerance or step as text: "1e-4", "2e-3 s".
std::string control_text(const MethodWork& method, const Trial& trial) {
  const double exponent = std::floor(std::log10(trial.control) + 1e-9);
  return fmt::format("{:.0f}e{:.0f}{}", trial.control / std::pow(10, exponent), exponent,
                     method.control == "step [s]" ? " s" : "");
}

/// The error of every trial over its processor time per impact; of a method without control only
/// the time.
Chart chart_of(const SceneWork& work) {
  const report::Range errors = errors_of(work);
  const bool chaotic = work.benchmark.chaotic;
  Chart chart{.name = "work",
              .title = fmt::format("Event-driven: {:.2g} µs per impact",
                                   1e6 * cost_of(work, work.methods.front().trials.front())),
              .x = {"processor time per impact [s]", Scale::logarithmic},
              .y = {chaotic ? "relative error of impacts per second" : "impact-time error [s]",
                    Scale::logarithmic, report::Range{errors.lower, 3 * errors.upper}},
              .lines = {{Direction::horizontal, errors.upper, "failed"}},
              .width = 640,
              .height = 400};
  for (const MethodWork& method : work.methods) {
    if (method.control == "none") {
      chart.lines.push_back(
          {Direction::vertical, cost_of(work, method.trials.front()), method.method});
      continue;
    }
    Series& series = chart.series.emplace_back(Series{method.method, Mark::points, {}});
    for (std::size_t i = 0; i < method.trials.size(); ++i) {
      const Trial& trial = method.trials[i];
      // Names beside all dots would hide the dots.
      const bool last = i + 1 == method.trials.size();
      const bool named = i == 0 || last || (!chaotic && i % named_every == 0);
      series.samples.push_back(
          {cost_of(work, trial),
           trial.error ? std::max(*trial.error, smallest_error(work)) : errors.upper,
           {},
           named ? control_text(method, trial) : ""});
    }
  }
  if (chaotic && work.rate_spread > errors.lower) {
    chart.lines.push_back({Direction::horizontal, work.rate_spread, "statistical resolution"});
  }
  return chart;
}

/// How many of the other methods are accurate enough.
std::string answer_of(const SceneWork& work) {
  const auto others = static_cast<std::ptrdiff_t>(work.methods.size()) - 1;
  std::vector<std::string> answers;
  for (const double limit : limits_of(work)) {
    const auto reached = std::ranges::count_if(
        work.methods | std::views::drop(1),
        [&](const MethodWork& method) { return slowdown(work, method, limit).has_value(); });
    const std::string what = work.benchmark.chaotic
                                 ? fmt::format("the rate within {:.2g} %", 100 * limit)
                                 : fmt::format("times to 1e{:.0f} s", std::log10(limit));
    answers.push_back(fmt::format("{}: {} of {}, {} not", what, reached, others, others - reached));
  }
  return fmt::format("Other methods that are right, {}.", fmt::join(answers, "; "));
}

/// What others pay for impact times right to a microsecond, where paths can be compared.
std::string cost_sentence(const std::vector<SceneWork>& works) {
  std::vector<double> ratios;
  std::size_t pairs = 0;
  for (const SceneWork& work : works) {
    const bool compliant = work.benchmark.scene.fidelity == Fidelity::compliant;
    for (std::size_t m = 1; m < work.methods.size() && !work.benchmark.chaotic && !compliant; ++m) {
      ++pairs;
      const auto ratio = slowdown(work, work.methods[m], limits_of(work).front());
      if (ratio) ratios.push_back(*ratio);
    }
  }
  const std::string rest = fmt::format(
      "in {} of {} pairs of method and scene no tolerance or step tried is accurate enough, in {} "
      "one is",
      pairs - ratios.size(), pairs, ratios.size());
  if (ratios.empty()) return "On hard walls " + rest + ".";
  const auto [least, most] = std::ranges::minmax(ratios);
  return fmt::format(
      "On hard walls impact times right to a microsecond cost other methods {:.1f} to {:.0f} times "
      "the processor time of the event-driven simulator; {}.",
      least, most, rest);
}

}  // namespace

void add_to(report::Results& results, const std::vector<SceneWork>& works) {
  Table costs{"accuracy-cost", {{"method"}}};
  Table all{"work",
            {{"scene"},
             {"method"},
             {"tightest", "tightest tolerance or step [s]", ".1e"},
             {"count_difference", "count difference", "+d"},
             {"missed"},
             {"spurious"},
             {"error", "error at the tightest", ".1e"},
             {"within_first", "time ratio, 1e-6 s or rate", ".1f"},
             {"within_second", "time ratio, 1e-9 s", ".1f"},
             {"evaluations", "evaluations, as in the first", ".1f"}}};
  for (std::size_t m = 1; m < works.front().methods.size(); ++m)
    costs.add(works.front().methods[m].method);
  for (const SceneWork& work : works) {
    const bool chaotic = work.benchmark.chaotic;
    costs.columns.push_back({work.benchmark.id, "", ".1f"});
    for (auto& row : costs.rows) row.emplace_back();
    const std::vector<double> limits = limits_of(work);
    for (const MethodWork& method : work.methods) {
      const Trial& tightest = method.trials.back();
      const auto if_path = [&](int count) {
        return tightest.finished && !chaotic ? std::optional(count) : std::nullopt;
      };
      const auto ratio = slowdown(work, method, limits.front());
      all.add(work.benchmark.id, method.method,
              method.control == "none" ? std::nullopt : std::optional(tightest.control),
              tightest.finished ? std::optional(tightest.accuracy.count_difference) : std::nullopt,
              if_path(tightest.accuracy.missed), if_path(tightest.accuracy.spurious),
              tightest.error, ratio, chaotic ? std::nullopt : slowdown(work, method, limits.back()),
              evaluations_ratio(work, method, limits.front()));
      for (auto& row : costs.rows)
        if (row.front() == value_of(method.method)) row.back() = value_of(ratio);
    }
    report::Part part{work.benchmark.id, work.benchmark.name, {}};
    part.results.set("description", work.benchmark.description);
    part.results.set("answer", answer_of(work));
    part.results.add(chart_of(work));
    if (chaotic) {
      results.set("mean-impacts", work.mean_impacts);
      results.set("rate-spread", work.rate_spread);
    }
    results.add("scene", std::move(part));
  }
  results.set("accuracy", cost_sentence(works));
  results.add(std::move(costs));
  results.add(std::move(all));
}

namespace {

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
       "1 kg between walls 1 mm apart, shaken at 10 Hz by 0.2 mm, restitution 0.5: a motion that "
       "forgets its start.",
       shaken_gap(1e-3, 0.5, 0.5)},
      {"fast", "Fast: case C2 at 10 rad/s",
       "Restitution 0.9, friction 0.1: the carrier hammers the track.", case_at("C2", 10)},
      {"sticking", "Sticking: case C3 at 9 rad/s",
       "Restitution 0.1, friction 0.4: the carrier comes to rest and breaks loose again.",
       case_at("C3", 9)},
      {"grazing", "Grazing: a wall that is just touched",
       "1 kg that swings by 2 mm and overshoots a wall by 10 nm, restitution 0.9. Touches count "
       "from 1 µm/s.",
       grazing()},
      {"chaotic", "Chaotic: a shaken gap with a pull",
       fmt::format("Walls 0.6 mm apart, restitution 0.8, a pull of half the shaking, {} s. After a "
                   "while rounding alone decides the path, so only impacts per second are "
                   "compared.",
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
        "The mild scene on walls of {:.0e} N/m^1.5. Methods go straight through the contacts; the "
        "reference lands on both edges of each.",
        stiffness);
    return result;
  };
  return {compliant("stiff", "Stiff: a shaken gap with walls that give way", 1e12),
          compliant("very-stiff", "Very stiff: the same, ten thousand times stiffer", 1e16)};
}

}  // namespace ricochet::studies::dynamics
