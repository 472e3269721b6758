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
  if (integrator.control == "step [s]") return once / (tight ? 1000 : 30);
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
  Scene sliding = block();
  sliding.start_velocity = 0.7;  // for 0.7 s and 0.7^2 / 2 m
  sliding.window = Seconds{2};
  const double control = control_of(integrator, strictness, 1);
  const double way = 0.7 * 0.7 / 2;
  sticking.stop_error = std::abs(integrator.run(sliding, control).end.position - way) / way;
  Scene pushed = block();
  pushed.pull = 0.9999;
  pushed.window = Seconds{10};
  sticking.creep = std::abs(integrator.run(pushed, control).end.position) / 10;
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

using report::Json;

/// A magnitude, and whether it is readable without a power of ten.
Json size_of(double value) {
  const double size = std::abs(value);
  return {{"size", size}, {"plain", size == 0 || (size >= 0.01 && size < 1000)}};
}

Json data_of(const Zeno& zeno) {
  const double late = zeno.rest_late;
  const bool rests = zeno.finished && zeno.rest;
  return {{"finished", zeno.finished},
          {"rests", rests},
          {"seconds_late", late},
          {"off", rests && std::abs(late) >= 1e-5 ? size_of(late) : Json()},
          {"early", late <= 0},
          {"good", rests && std::abs(late) < std::max(1e-5, 1e-3 * zeno.end_of_impacts)}};
}

/// The least overshoot from which on all shares are one; nothing if there is none.
std::optional<double> all_right_from(const std::vector<double>& overshoots,
                                     const std::vector<double>& shares) {
  std::optional<double> least;
  for (std::size_t k = 0; k < shares.size() && shares[k] == 1; ++k) least = overshoots[k];
  return least;
}

Json grazes_of(const MethodFailures& method, const std::vector<double>& overshoots) {
  const auto seen = all_right_from(overshoots, method.touched);
  const auto spared = all_right_from(overshoots, method.missed);
  const bool sees_all = seen == overshoots.back();
  const bool invents_none = spared == overshoots.back();
  return {{"seen_from", seen},
          {"sees_all", sees_all},
          {"spared_from", spared},
          {"invents_none", invents_none},
          {"good", sees_all && invents_none}};
}

Json data_of(const Sticking& sticking, int decades) {
  const bool in_time = sticking.noticed && *sticking.noticed < 1.5 * std::pow(10.0, -decades);
  return {{"gave_up", sticking.gave_up},
          {"creep", sticking.creep > 0 ? size_of(sticking.creep) : Json()},
          {"noticed", sticking.noticed},
          {"in_time", in_time},
          {"too_early", sticking.breaks_loose_early},
          {"good",
           !sticking.gave_up && in_time && sticking.creep == 0 && !sticking.breaks_loose_early}};
}

Json elastic_data(const Elastic& elastic) {
  const double ratio = elastic.energy_ratio;
  const double drift = ratio - 1;
  const bool lost = ratio<0.01, multiplied = ratio> 2, kept = std::abs(drift) < 1e-8;
  return {{"strikes", elastic.seen > 0},
          {"seen", elastic.seen},
          {"impacts", elastic.impacts},
          {"sees_all", elastic.seen == elastic.impacts},
          {"energy_ratio", ratio},
          {"lost", lost},
          {"multiplied", multiplied},
          {"kept", kept},
          {"percent", lost || multiplied || kept ? Json() : size_of(100 * drift)},
          {"gains", drift > 0},
          {"good", elastic.seen == elastic.impacts && std::abs(drift) < 1e-3}};
}

Json data_of(const ChaoticRate& rate) {
  return {{"finished", rate.finished},
          {"error", rate.error},
          {"good", rate.finished && std::abs(rate.error) <= rate.uncertainty}};
}

Json data_of(const FailureModeStudy& study, const MethodFailures& method) {
  return {{"method", method.method},
          {"zeno", data_of(method.zeno)},
          {"grazes", grazes_of(method, study.overshoots)},
          {"sticking", data_of(method.sticking, study.plan.decades)},
          {"elastic", report::list_of(method.elastic, elastic_data)},
          {"rate", data_of(method.rate)}};
}

/// By how much a wall is missed (-) or overshot (+), in swings, in the order of rights_of.
Json touches_of(const std::vector<double>& overshoots) {
  Json touches = Json::array();
  for (const double by : overshoots) {
    touches.push_back(fmt::format("-1e{:.0f}", std::log10(by)));
  }
  for (auto by = overshoots.rbegin(); by != overshoots.rend(); ++by) {
    touches.push_back(fmt::format("+1e{:.0f}", std::log10(*by)));
  }
  return touches;
}

/// Share of correct decisions of a method, in whole per cent.
Json rights_of(const MethodFailures& method) {
  Json rights = Json::array();
  for (const double share : method.missed) rights.push_back(std::round(100 * share));
  for (auto share = method.touched.rbegin(); share != method.touched.rend(); ++share) {
    rights.push_back(std::round(100 * *share));
  }
  return {{"method", method.method}, {"right", std::move(rights)}};
}

/// Number of failure modes in which a method of control_data fails.
int failures(const Json& method) {
  int failed = 0;
  for (const char* mode : {"zeno", "grazes", "sticking", "rate"}) {
    failed += method[mode]["good"] == false;
  }
  for (const Json& elastic : method["elastic"]) failed += elastic["good"] == false;
  return failed;
}

/// Number of methods that fail in a failure mode.
int failing(const Json& methods, const char* mode) {
  return static_cast<int>(std::count_if(methods.begin(), methods.end(), [&](const Json& method) {
    return method[mode]["good"] == false;
  }));
}

Json control_data(const FailureModeStudy& study, const std::vector<MethodFailures>& methods,
                  const std::string& control) {
  const auto failures_of = [&](const MethodFailures& method) { return data_of(study, method); };
  Json rows = report::list_of(methods, failures_of);
  const int grazes = failing(rows, "grazes");
  return {{"control", control},
          {"tight", control == "tight"},
          {"failing", {{"of", methods.size()}, {"grazes", grazes}}},
          {"methods", std::move(rows)},
          {"rights", report::list_of(methods, rights_of)}};
}

}  // namespace

Json data_of(const FailureModeStudy& study) {
  const FailureModePlan& plan = study.plan;
  const Json loose = control_data(study, study.loose, "loose");
  const Json tight = control_data(study, study.tight, "tight");
  const Json& methods = tight["methods"];
  Json flawless = Json::array();
  int most = -1;
  std::string worst;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const std::string& name = study.tight[m].method;
    const int failed = failures(methods[m]);
    if (failed + failures(loose["methods"][m]) == 0) flawless.push_back(name);
    if (failed > most) worst = name;
    most = std::max(most, failed);
  }
  return {{"losses", study.losses},
          {"touches", touches_of(study.overshoots)},
          {"end_of_impacts", study.tight.front().zeno.end_of_impacts},
          {"least_excess", std::pow(10.0, -plan.decades)},
          {"impacts", plan.impacts},
          {"starts", plan.starts},
          {"seconds", plan.seconds},
          {"uncertainty", study.tight.front().rate.uncertainty},
          {"modes", 4 + study.losses.size()},
          {"flawless", std::move(flawless)},
          {"worst", {{"method", worst}, {"failed", most}}},
          {"failing",
           {{"of", methods.size()},
            {"grazes", failing(methods, "grazes")},
            {"sticking", failing(methods, "sticking")},
            {"zeno", failing(methods, "zeno")},
            {"rate", failing(methods, "rate")}}},
          {"controls", Json::array({loose, tight})}};
}

}  // namespace ricochet::studies::dynamics
