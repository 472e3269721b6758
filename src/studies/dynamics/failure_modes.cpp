#include "src/studies/dynamics/failure_modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "problems/carrier_track/check/integrator.h"
#include "ricochet/machine.h"
#include "src/core/progress.h"
#include "src/studies/dynamics/work.h"

namespace ricochet::studies::dynamics {

namespace {

using namespace carrier_track;

using std::numbers::pi;
constexpr double gravity = 9.8;  // [m/s^2]
constexpr int angles = 32;       // start angles of swings, and angles of peaks

/// A ball that is dropped, falls for `fall` [s], and bounces.
Scene ball(double fall, double restitution, double seconds) {
  Scene scene;
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.start_position = 0.5 * gravity * fall * fall;
  scene.pull = gravity;
  scene.restitution_lower = restitution;
  scene.window = Seconds{seconds};
  return scene;
}

/// Time [s] of impact k = 0, 1, ... of that ball.
double impact_time(double fall, double restitution, double k) {
  return fall * (1 + restitution - 2 * std::pow(restitution, k + 1)) / (1 - restitution);
}

/// A block in the middle of a gap of 1 m, with friction 1 m/s^2.
Scene block() {
  Scene scene;
  scene.wall_lower = -0.5;
  scene.wall_upper = 0.5;
  scene.start_position = 0;
  scene.friction = 1;
  scene.normal_force = 1;
  return scene;
}

/// Tests if a resting block breaks loose under a force of period 2 pi s that peaks at angle `peak`
/// [rad], at 1 + excess times friction.
Outcome pushed_for_a_moment(const Integrator& integrator, Strictness strictness, double excess,
                            double peak) {
  Scene scene = block();
  scene.centrifugal_mass_radius = 1 + excess;  // omega is 1 rad/s
  scene.phase = -peak;
  scene.window = Seconds{peak + 1};  // the opposite peak comes later
  return integrator.run(scene, control_of(integrator, strictness, 2 * pi));
}

struct Sample {
  double mean = 0, variance = 0;
  bool finished = true;
};

/// Counted impacts over runs whose start velocities differ by 1 % each.
Sample impacts_of(const Integrator& integrator, const Scene& scene, double control, int starts) {
  Sample sample;
  double squares = 0;
  for (int k = 0; k < starts; ++k) {
    Scene start = scene;
    start.start_velocity *= 1 + 0.01 * k;
    const Outcome outcome = integrator.run(start, control);
    sample.finished = sample.finished && outcome.finished;
    const double impacts = collisions(start, outcome);
    sample.mean += impacts / starts;
    squares += impacts * impacts / starts;
  }
  sample.variance = std::max(0.0, squares - sample.mean * sample.mean);
  return sample;
}

}  // namespace

double control_of(const Integrator& integrator, Strictness strictness, double once) {
  const bool tight = strictness == Strictness::tight;
  if (integrator.setting == "step [s]") return once / (tight ? 1000 : 30);
  return tight ? 1e-10 : 1e-4;
}

Zeno zeno_of(const Integrator& integrator, Strictness strictness) {
  const double fall = std::sqrt(2 * 50 / gravity);  // [s], from 50 m
  constexpr double e = 0.8;
  Zeno zeno{};
  zeno.end_of_impacts = impact_time(fall, e, std::numeric_limits<double>::infinity());
  const Scene scene = ball(fall, e, 1.25 * zeno.end_of_impacts);
  const Outcome outcome = integrator.run(scene, control_of(integrator, strictness, 2 * fall));
  zeno.finished = outcome.finished;
  zeno.impacts = outcome.impacts.size();
  if (outcome.impacts.empty()) return zeno;
  zeno.rest_late = outcome.impacts.back().time - zeno.end_of_impacts;
  if (outcome.end.velocity == 0) zeno.rest = outcome.impacts.back().time;
  if (zeno.impacts < 20) return zeno;
  double error = 0;
  for (std::size_t k = 0; k < 20; ++k) {
    const double true_values = impact_time(fall, e, static_cast<double>(k));
    error = std::max(error, std::abs(outcome.impacts[k].time - true_values));
  }
  zeno.error = error;
  return zeno;
}

double grazes_right(const Integrator& integrator, Strictness strictness, double overshoot) {
  constexpr double swing = 2e-3;    // [m]
  constexpr double frequency = 10;  // [rad/s]
  Scene scene;
  scene.wall_upper = 0;
  scene.wall_lower = -2 * swing;
  scene.omega = frequency;
  scene.centrifugal_mass_radius = 0.5 * swing;
  int right = 0;
  for (int k = 0; k < angles; ++k) {
    // x + (swing / 2) cos(angle) is constant, and the summit is at the angle pi.
    const double angle = 0.3 + 1.0 * k / angles;
    scene.phase = angle;
    scene.start_position = swing * (overshoot - 0.5 * (1 + std::cos(angle)));
    scene.start_velocity = 0.5 * swing * frequency * std::sin(angle);
    scene.window = Seconds{(1.5 * pi - angle) / frequency};
    const Outcome outcome =
        integrator.run(scene, control_of(integrator, strictness, 2 * pi / frequency));
    right += outcome.impacts.empty() == (overshoot < 0);
  }
  return static_cast<double>(right) / angles;
}

Sticking sticking_of(const Integrator& integrator, Strictness strictness, int decades) {
  Sticking sticking{};
  Scene pushed = block();
  pushed.pull = 0.9999;
  pushed.window = Seconds{10};
  sticking.creep =
      std::abs(integrator.run(pushed, control_of(integrator, strictness, 1)).end.position) / 10;
  bool all = true;
  for (int k = 1; k <= decades && !sticking.gave_up; ++k) {
    const double excess = std::pow(10.0, -k);
    for (int i = 0; i < angles && !sticking.gave_up; ++i) {
      const double peak = 0.5 + 1.0 * i / angles;
      const Outcome over = pushed_for_a_moment(integrator, strictness, excess, peak);
      const Outcome short_of = pushed_for_a_moment(integrator, strictness, -excess, peak);
      // NOTE: a run that gives up has taken a million steps, so the series ends here.
      if (!over.finished || !short_of.finished) sticking.gave_up = excess;
      all = all && over.finished && over.end.position != 0;
      sticking.breaks_loose_early |= short_of.end.position != 0;
    }
    if (all) sticking.noticed = excess;
  }
  return sticking;
}

Elastic elastic_of(const Integrator& integrator, Strictness strictness, double loss,
                   std::size_t impacts) {
  constexpr double fall = 0.1;  // [s]
  const double e = 1 - loss;
  const double count = static_cast<double>(impacts);
  const Scene scene = ball(fall, e, impact_time(fall, e, count - 0.5));
  const Outcome outcome = integrator.run(scene, control_of(integrator, strictness, 2 * fall));
  Elastic elastic{impacts, std::min(impacts, outcome.impacts.size()), 0};
  if (elastic.seen == 0) return elastic;
  const double before = gravity * fall * std::pow(e, static_cast<double>(elastic.seen) - 1);
  elastic.energy_ratio = std::pow(outcome.impacts[elastic.seen - 1].speed / before, 2);
  return elastic;
}

ChaoticRate rate_of(const Integrator& integrator, Strictness strictness, double seconds,
                    int starts) {
  const Scene scene = benchmark_scene("chaotic", seconds);
  constexpr int exact_starts = 64;
  const Sample exact = impacts_of(all_integrators().front(), scene, 1, exact_starts);
  const Outcome one = all_integrators().front().run(scene, 1);
  const double pause = seconds / std::max(1, collisions(scene, one));
  const Sample sample =
      impacts_of(integrator, scene, control_of(integrator, strictness, pause), starts);
  const double error = std::sqrt(exact.variance * (1.0 / starts + 1.0 / exact_starts));
  return {sample.mean / exact.mean - 1, 3 * error / exact.mean, sample.finished};
}

FailureModeStudy study_failure_modes(const FailureModePlan& plan,
                                     const std::vector<Integrator>& integrators) {
  FailureModeStudy study{plan, {}, {1e-4, 1e-6}, {}, {}};
  for (int k = 3; k <= 15; k += 2) study.overshoots.push_back(std::pow(10.0, -k));
  Progress progress("failure modes", 2.0 * static_cast<double>(integrators.size()));
  for (const Strictness strictness : {Strictness::loose, Strictness::tight}) {
    for (const Integrator& integrator : integrators) {
      MethodFailures failures{integrator.name,
                              zeno_of(integrator, strictness),
                              {},
                              {},
                              sticking_of(integrator, strictness, plan.decades),
                              {},
                              rate_of(integrator, strictness, plan.seconds, plan.starts)};
      for (const double overshoot : study.overshoots) {
        failures.touched.push_back(grazes_right(integrator, strictness, overshoot));
        failures.missed.push_back(grazes_right(integrator, strictness, -overshoot));
      }
      for (const double loss : study.losses) {
        failures.elastic.push_back(elastic_of(integrator, strictness, loss, plan.impacts));
      }
      (strictness == Strictness::loose ? study.loose : study.tight).push_back(std::move(failures));
      progress.advance(1);
    }
  }
  return study;
}

namespace {

bool is_good(const Zeno& zeno) {
  return zeno.finished && zeno.rest &&
         std::abs(zeno.rest_late) < std::max(1e-5, 1e-3 * zeno.end_of_impacts);
}

/// The least overshoot from which on all shares are one; nothing if there is none.
std::optional<double> all_right_from(const std::vector<double>& overshoots,
                                     const std::vector<double>& shares) {
  std::optional<double> least;
  for (std::size_t k = 0; k < shares.size() && shares[k] == 1; ++k) least = overshoots[k];
  return least;
}

bool are_grazes_good(const MethodFailures& method) {
  const auto right = [](double share) { return share == 1; };
  return std::ranges::all_of(method.touched, right) && std::ranges::all_of(method.missed, right);
}

bool is_good(const Sticking& sticking, int decades) {
  const bool in_time = sticking.noticed && *sticking.noticed < 1.5 * std::pow(10.0, -decades);
  return !sticking.gave_up && in_time && sticking.creep == 0 && !sticking.breaks_loose_early;
}

bool is_good(const Elastic& elastic) {
  return elastic.seen == elastic.impacts && std::abs(elastic.energy_ratio - 1) < 1e-3;
}

bool is_good(const ChaoticRate& rate) {
  return rate.finished && std::abs(rate.error) <= rate.uncertainty;
}

/// Number of failure modes in which a method fails.
int failures_of(const MethodFailures& method, int decades) {
  int failed = !is_good(method.zeno) + !are_grazes_good(method) +
               !is_good(method.sticking, decades) + !is_good(method.rate);
  for (const Elastic& elastic : method.elastic) failed += !is_good(elastic);
  return failed;
}

std::string finding_of(const FailureModeStudy& study) {
  const int decades = study.plan.decades;
  std::vector<std::string> flawless;
  int most = -1, zeno = 0, grazes = 0, sticking = 0, rate = 0;
  std::string worst;
  for (std::size_t m = 0; m < study.tight.size(); ++m) {
    const MethodFailures& method = study.tight[m];
    const int failed = failures_of(method, decades);
    if (failed + failures_of(study.loose[m], decades) == 0) flawless.push_back(method.method);
    if (failed > most) worst = method.method;
    most = std::max(most, failed);
    zeno += !is_good(method.zeno);
    grazes += !are_grazes_good(method);
    sticking += !is_good(method.sticking, decades);
    rate += !is_good(method.rate);
  }
  const std::size_t modes = 4 + study.losses.size();
  return fmt::format(
      "Right in all {} failure modes, at the loose and the tight setting: {}. At the tight setting "
      "{} of {} methods fail on a wall that is just touched or missed, {} on sticking, {} on "
      "endless bouncing, {} on the rate of impacts in chaos; {} fails most, {} of {}.",
      modes, flawless.empty() ? "no method" : fmt::format("{}", fmt::join(flawless, ", ")), grazes,
      study.tight.size(), sticking, zeno, rate, worst, most, modes);
}

/// Share of correct decisions of each method on a wall that is missed by less and less, and then
/// touched by more and more.
report::Chart graze_chart(const FailureModeStudy& study) {
  const auto failing = std::ranges::count_if(
      study.tight, [](const MethodFailures& method) { return !are_grazes_good(method); });
  report::Chart chart{
      .name = "grazes",
      .title = fmt::format("Tight setting: {} of {} methods miss a touch or invent one", failing,
                           study.tight.size()),
      .x = {"wall missed by (-) or overshot by (+), in swings"},
      .y = {"method"},
      .heat_map = report::HeatMap{"right [%]", {}, report::Range{0, 100}},
      .width = 900,
      .height = 340};
  const auto& by = study.overshoots;
  for (const double x : by) chart.x.categories.push_back(fmt::format("-1e{:.0f}", std::log10(x)));
  for (auto x = by.rbegin(); x != by.rend(); ++x)
    chart.x.categories.push_back(fmt::format("+1e{:.0f}", std::log10(*x)));
  for (auto method = study.tight.rbegin(); method != study.tight.rend(); ++method) {
    chart.y.categories.push_back(method->method);
    auto& row = chart.heat_map->rows.emplace_back();
    for (const double share : method->missed) row.emplace_back(std::round(100 * share));
    for (auto share = method->touched.rbegin(); share != method->touched.rend(); ++share)
      row.emplace_back(std::round(100 * *share));
  }
  return chart;
}

}  // namespace

void add_to(report::Results& results, const FailureModeStudy& study) {
  Table table{"failure-modes",
              {{"method"},
               {"setting"},
               {"rest_late", "rests late by [s]", ".2g"},
               {"touches_from", "sees touches from [swings]", ".0e"},
               {"misses_from", "invents none from [swings]", ".0e"},
               {"excess_from", "breaks loose from an excess of", ".0e"}}};
  for (const double loss : study.losses) {
    table.columns.push_back({fmt::format("energy_{:.0e}", loss),
                             fmt::format("energy, restitution 1 - {:.0e} [%]", loss), "+.2%"});
  }
  table.columns.push_back({"rate", "impacts in chaos [%]", "+.1%"});
  table.columns.push_back({"failed", "modes failed"});
  for (const auto& [setting, methods] :
       {std::pair("tight", &study.tight), std::pair("loose", &study.loose)}) {
    for (const MethodFailures& method : *methods) {
      const bool rests = method.zeno.finished && method.zeno.rest;
      std::vector<Value> row = {
          value_of(method.method),
          value_of(setting),
          value_of(rests ? std::optional(method.zeno.rest_late) : std::nullopt),
          value_of(all_right_from(study.overshoots, method.touched)),
          value_of(all_right_from(study.overshoots, method.missed)),
          value_of(method.sticking.gave_up ? std::nullopt : method.sticking.noticed)};
      for (const Elastic& elastic : method.elastic) {
        row.push_back(
            value_of(elastic.seen > 0 ? std::optional(elastic.energy_ratio - 1) : std::nullopt));
      }
      row.push_back(
          value_of(method.rate.finished ? std::optional(method.rate.error) : std::nullopt));
      row.push_back(value_of(failures_of(method, study.plan.decades)));
      table.add_row(std::move(row));
    }
  }
  results.set("failure-modes-finding", finding_of(study));
  results.set("end-of-impacts", study.tight.front().zeno.end_of_impacts);
  results.set("least-excess", std::pow(10.0, -study.plan.decades));
  results.set("elastic-impacts", study.plan.impacts);
  results.set("chaotic-runs", study.plan.starts);
  results.set("rate-uncertainty", study.tight.front().rate.uncertainty);
  results.set("modes", 4 + study.losses.size());
  results.add(std::move(table));
  results.add(graze_chart(study));
}

}  // namespace ricochet::studies::dynamics
