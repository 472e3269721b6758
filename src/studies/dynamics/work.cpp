#include "src/studies/dynamics/work.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/scene_fields.h"
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
  MethodWork work{integrator.name, integrator.control, {}};
  std::vector<double> values = {1.0};
  if (integrator.control == "step [s]") {
    const double pause = duration_of(scene) / scene_work.impacts;  // [s] between two impacts
    values = controls(0.1 * pause, pause / plan.steps, plan.per_decade);
  } else if (integrator.control != "none") {
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

using report::Json;

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

/// A small ratio is shown with one decimal.
Json data_of(const std::optional<double>& ratio) {
  return {{"ratio", ratio}, {"small", ratio && *ratio < 10}};
}

bool fails(const Trial& trial, bool chaotic) {
  return !trial.finished || (!chaotic && trial.accuracy.missed + trial.accuracy.spurious > 0);
}

/// Smallest error that is drawn: the rounding of a time, or half an impact in the rate.
double smallest_error(const SceneWork& work) {
  return work.benchmark.chaotic ? 0.5 / work.impacts : 1e-16;
}

double cost_of(const SceneWork& work, const Trial& trial) {
  return trial.seconds / work.impacts;
}

struct Errors {
  double lower, upper;
};

/// From the decade below the smallest error to the decade above the largest, where failures are
/// drawn.
Errors errors_of(const SceneWork& work) {
  Errors range{1e-3, 1e-3};
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

/// Adds the error of every trial over its processor time per impact [s]; for a method without
/// control only the time.
void add_trials(const SceneWork& work, Json& data) {
  const Errors errors = errors_of(work);
  const double spread = work.rate_spread;
  data["bottom"] = errors.lower;
  data["failed_at"] = errors.upper;
  data["top"] = 3 * errors.upper;
  data["shown_spread"] = work.benchmark.chaotic && spread > errors.lower ? Json(spread) : Json();
  data["exact"] = data["controlled"] = Json::array();
  for (const MethodWork& method : work.methods) {
    if (method.control == "none") {
      data["exact"].push_back(
          {{"method", method.method}, {"cost", cost_of(work, method.trials.front())}});
      continue;
    }
    Json trials = Json::array();
    for (std::size_t i = 0; i < method.trials.size(); ++i) {
      const Trial& trial = method.trials[i];
      const std::string control = control_text(method, trial);
      // Names beside all dots would hide the dots.
      const bool last = i + 1 == method.trials.size();
      const bool named = i == 0 || last || (!work.benchmark.chaotic && i % named_every == 0);
      trials.push_back(
          {{"cost", cost_of(work, trial)},
           {"error", trial.error ? std::max(*trial.error, smallest_error(work)) : errors.upper},
           {"control", control},
           {"named", named ? control : ""}});
    }
    data["controlled"].push_back({{"method", method.method}, {"trials", std::move(trials)}});
  }
}

/// Lists the other methods within a limit, and the fastest of them.
Json data_of(const SceneWork& work, double limit) {
  Json best;
  int reached = 0;
  for (std::size_t m = 1; m < work.methods.size(); ++m) {
    const auto ratio = slowdown(work, work.methods[m], limit);
    if (!ratio) continue;
    ++reached;
    if (!best.is_null() && *ratio >= best["ratio"]) continue;
    best = data_of(ratio);
    best["method"] = work.methods[m].method;
  }
  return {{"seconds",
           work.benchmark.chaotic ? Json() : Json(fmt::format("1e{:.0f}", std::log10(limit)))},
          {"best", std::move(best)},
          {"reached", reached},
          {"others", work.methods.size() - 1}};
}

/// A method at its tightest control, and its cost at the limits.
Json data_of(const SceneWork& work, const MethodWork& method) {
  const Trial& tightest = method.trials.back();
  const bool chaotic = work.benchmark.chaotic;
  const auto if_known = [](bool known, int value) { return known ? Json(value) : Json(); };
  Json data = {
      {"method", method.method},
      {"tightest", method.control == "none" ? Json() : Json(tightest.control)},
      {"step", method.control == "step [s]"},
      {"finished", tightest.finished},
      {"count_difference", if_known(tightest.finished, tightest.accuracy.count_difference)},
      {"missed", if_known(tightest.finished && !chaotic, tightest.accuracy.missed)},
      {"spurious", if_known(tightest.finished && !chaotic, tightest.accuracy.spurious)},
      {"error", tightest.error},
      {"good", fails(tightest, chaotic) ? Json(false) : Json()},
      {"times", Json::array()}};
  for (const double limit : limits_of(work)) {
    data["times"].push_back(data_of(slowdown(work, method, limit)));
  }
  return data;
}

}  // namespace

Json data_of(const SceneWork& work) {
  const BenchmarkScene& benchmark = work.benchmark;
  const auto if_chaotic = [&](double value) { return benchmark.chaotic ? Json(value) : Json(); };
  Json data = {{"id", benchmark.id},
               {"name", benchmark.name},
               {"description", benchmark.description},
               {"chaotic", benchmark.chaotic},
               {"impacts", work.impacts},
               {"microseconds", 1e6 * cost_of(work, work.methods.front().trials.front())},
               {"mean_impacts", if_chaotic(work.mean_impacts)},
               {"spread_percent", if_chaotic(100 * work.rate_spread)},
               {"limits", Json::array()},
               {"failing", Json::array()},
               {"methods", Json::array()}};
  for (const double limit : limits_of(work)) data["limits"].push_back(data_of(work, limit));
  for (const MethodWork& method : work.methods) {
    data["methods"].push_back(data_of(work, method));
    if (fails(method.trials.back(), benchmark.chaotic)) data["failing"].push_back(method.method);
  }
  add_trials(work, data);
  return data;
}

Json speed_data(const std::vector<SceneWork>& works) {
  Json data = {{"scenes", Json::array()}, {"times", Json::array()}, {"evaluations", Json::array()}};
  for (const SceneWork& work : works) data["scenes"].push_back(work.benchmark.id);
  std::vector<double> compared;
  int failed = 0;
  for (std::size_t m = 1; m < works.front().methods.size(); ++m) {
    Json times = Json::array(), evaluations = Json::array();
    for (const SceneWork& work : works) {
      const double limit = limits_of(work).front();
      const auto time = slowdown(work, work.methods[m], limit);
      times.push_back(data_of(time));
      evaluations.push_back(data_of(evaluations_ratio(work, work.methods[m], limit)));
      if (work.benchmark.chaotic) continue;
      failed += time ? 0 : 1;
      if (time) compared.push_back(*time);
    }
    const std::string& method = works.front().methods[m].method;
    data["times"].push_back({{"method", method}, {"ratios", std::move(times)}});
    data["evaluations"].push_back({{"method", method}, {"ratios", std::move(evaluations)}});
  }
  std::sort(compared.begin(), compared.end());
  const bool any = !compared.empty();
  data["least"] = data_of(any ? std::optional(compared.front()) : std::nullopt);
  data["most"] = data_of(any ? std::optional(compared.back()) : std::nullopt);
  data["failed"] = failed;
  data["pairs"] = compared.size() + static_cast<std::size_t>(failed);
  return data;
}

namespace {

double distance(const ReturnedRestitution& point) {
  return std::abs(point.returned - point.asked);
}

constexpr double faithful_within = 0.01;

Json data_of(const LawStudy& law) {
  const ReturnedRestitution worst = worst_of(law);
  const double off = distance(worst);
  const bool exact = off < 5e-4;  // its worst place depends on rounding only
  return {{"law", law.name},
          {"exact", exact},
          {"worst_asked", exact ? Json() : Json(worst.asked)},
          {"worst_returned", exact ? Json() : Json(worst.returned)},
          {"off", off},
          {"faithful", off < faithful_within ? Json(true) : Json()},
          {"of_a_tenth", closed_return(law.law, 0.1)},
          {"of_nine_tenths", closed_return(law.law, 0.9)},
          {"measurement_error", largest_measurement_error(law)}};
}

}  // namespace

ReturnedRestitution worst_of(const LawStudy& study) {
  return *std::max_element(study.exact.begin(), study.exact.end(),
                           [](const auto& a, const auto& b) { return distance(a) < distance(b); });
}

double largest_measurement_error(const LawStudy& study) {
  double largest = 0;
  for (const ReturnedRestitution& point : study.measured) {
    largest = std::max(largest, std::abs(point.returned - closed_return(study.law, point.asked)));
  }
  return largest;
}

double closed_return(ContactLaw law, double asked) {
  if (law != ContactLaw::kelvin_voigt) return returned_restitution(dissipation(law, asked));
  return kelvin_voigt_restitution(damping_ratio(asked, Release::zero_force), Release::zero_force);
}

double measured_return(ContactLaw law, double asked) {
  Scene scene;  // 1 kg without any force, 1 mm above the only wall
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.restitution_lower = scene.restitution_upper = asked;
  scene.start_position = 1e-3;
  scene.start_velocity = -1;
  scene.window = Seconds{1};
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = law;
  if (law == ContactLaw::kelvin_voigt) scene.contact_exponent = 1;
  Observer nobody;
  return simulate(scene, nobody).velocity / -scene.start_velocity;
}

std::vector<LawStudy> study_laws(std::size_t stride) {
  std::vector<LawStudy> studies;
  for (const auto& [name, law] : contact_law_names()) {
    LawStudy& study = studies.emplace_back(LawStudy{std::string(name), law, {}, {}});
    for (std::size_t k = 2; k <= 98; ++k) {
      const double asked = 0.01 * static_cast<double>(k);
      study.exact.push_back({asked, closed_return(law, asked)});
      if ((k - 2) % stride == 0) study.measured.push_back({asked, measured_return(law, asked)});
    }
  }
  return studies;
}

Json data_of(const std::vector<LawStudy>& laws) {
  const double asked = 0.1;
  const double returned = closed_return(ContactLaw::hunt_crossley, asked);
  Json data = {{"hunt_crossley",
                {{"asked", asked},
                 {"returned", returned},
                 {"energy_asked", asked * asked},
                 {"energy_returned", returned * returned}}},
               {"faithful", Json::array()},
               {"laws", Json::array()},
               {"curves", Json::array()},
               {"measured", Json::array()}};
  for (const LawStudy& law : laws) {
    data["laws"].push_back(data_of(law));
    data["curves"].push_back({{"law", law.name}, {"exact", law.exact}});
    for (const ReturnedRestitution& one : law.measured) data["measured"].push_back(one);
    if (distance(worst_of(law)) <= faithful_within) data["faithful"].push_back(law.name);
  }
  return data;
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
