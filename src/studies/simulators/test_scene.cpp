#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "problems/carrier_track/check/oracle.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "src/core/names.h"
#include "src/studies/simulators/suite.h"

namespace ricochet::studies::simulators {

namespace {

using namespace carrier_track;

using Real = long double;
using Polynomial = std::array<Real, 3>;

constexpr Real pi = std::numbers::pi_v<Real>;

/// The driver plate from a time on: alpha + omega u + slope u^2 / 2.
struct Leg {
  Real from, alpha, omega, slope;
};

std::vector<Leg> legs_of(const Scene& machine) {
  const Real phase = machine.phase;
  if (machine.profile.empty()) return {{0, phase, machine.omega, 0}};
  std::vector<Leg> legs = {{0, phase, machine.profile.front().omega, 0}};
  for (std::size_t k = 0; k < machine.profile.size(); ++k) {
    const auto& [time, omega] = machine.profile[k];
    const Leg& last = legs.back();
    const Real since = time - last.from;
    Leg leg{time, last.alpha + since * (last.omega + last.slope * since / 2), omega, 0};
    if (k + 1 < machine.profile.size()) {
      const auto& next = machine.profile[k + 1];
      leg.slope = (static_cast<Real>(next.omega) - omega) / (static_cast<Real>(next.time) - time);
    }
    if (since > 0) {
      legs.push_back(leg);
    } else {
      legs.back() = leg;
    }
  }
  for (Leg& leg : legs) leg.alpha = std::remainder(leg.alpha, 2 * pi);
  return legs;
}

std::array<double, 3> rounded(const Polynomial& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// Collects the terms of a segment, without those that are zero.
class Terms {
 public:
  void add(const Polynomial& amplitude, const Polynomial& phase) {
    const auto a = rounded(amplitude);
    if (std::ranges::all_of(a, [](double x) { return x == 0; })) return;
    terms_.push_back({a, rounded(phase)});
  }
  std::vector<ForceTerm> take() { return std::move(terms_); }

 private:
  std::vector<ForceTerm> terms_;
};

ForceSegment segment_of(const Scene& machine, const Leg& leg) {
  const Polynomial square = {leg.omega * leg.omega, 2 * leg.omega * leg.slope,
                             leg.slope * leg.slope};
  const auto times = [](Real factor, Polynomial p) {
    for (Real& x : p) x *= factor;
    return p;
  };
  const auto turned = [&](Real by) { return Polynomial{leg.alpha + by, leg.omega, leg.slope / 2}; };
  Polynomial steady = {};
  Real plate = -static_cast<Real>(machine.slider_mass_radius);
  const Real centrifugal = machine.centrifugal_mass_radius;
  if (machine.centrifugal == Centrifugal::projected) plate += centrifugal;
  if (machine.centrifugal == Centrifugal::inward) steady = times(-centrifugal, square);
  if (machine.centrifugal == Centrifugal::outward) steady = times(centrifugal, square);
  if (!machine.pull_rotates) steady[0] -= machine.pull;
  Terms terms;
  terms.add(steady, {});
  terms.add(times(plate, square), turned(0));
  // -omega' sin alpha = -omega' cos(alpha - pi / 2)
  terms.add({-machine.slider_mass_radius * leg.slope, 0, 0}, turned(-pi / 2));
  if (machine.pull_rotates) terms.add({-machine.pull, 0, 0}, turned(machine.pull_phase));
  const Real frequency = machine.disturbance_frequency;
  terms.add(
      {machine.disturbance, 0, 0},
      {std::remainder(machine.disturbance_phase + frequency * leg.from, 2 * pi), frequency, 0});
  return {static_cast<double>(leg.from), terms.take()};
}

double polynomial(const std::array<double, 3>& p, double u) {
  return p[0] + u * (p[1] + u * p[2]);
}

}  // namespace

TestScene test_scene(const Scene& machine) {
  TestScene scene;
  scene.mass = machine.mass;
  scene.lower = machine.wall_lower;
  if (std::isfinite(machine.wall_upper)) scene.upper = machine.wall_upper;
  scene.restitution_lower = machine.restitution_lower;
  scene.restitution_upper = machine.restitution_upper;
  scene.friction = machine.friction * machine.normal_force;
  scene.position = machine.start_position;
  scene.velocity = machine.start_velocity;
  scene.duration = duration_of(machine);
  scene.slowest = machine.counting_limit;
  for (const Leg& leg : legs_of(machine)) {
    if (leg.from < scene.duration) scene.force.push_back(segment_of(machine, leg));
  }
  return scene;
}

double force_at(const TestScene& scene, double time) {
  const auto next = std::upper_bound(scene.force.begin(), scene.force.end(), time,
                                     [](double t, const ForceSegment& s) { return t < s.from; });
  const ForceSegment& segment = *(next - 1);
  double sum = 0;
  for (const ForceTerm& term : segment.terms) {
    const double u = time - segment.from;
    sum += polynomial(term.amplitude, u) * std::cos(polynomial(term.phase, u));
  }
  return sum;
}

namespace {

using report::Json;

/// The keys of the endings that have a reason.
constexpr std::array<std::pair<const char*, Ending>, 3> reasons = {
    {{"cannot", Ending::cannot}, {"error", Ending::error}, {"never", Ending::never}}};

constexpr std::size_t shown_of_a_line = 80;  // bytes

const char* name_of(Wall wall) {
  return wall == Wall::upper ? "upper" : "lower";
}

Impact impact_in(const Json& json) {
  const double time = json.at(0).get<double>();
  const auto wall = json.at(1).get<std::string>();
  const double speed = json.at(2).get<double>();
  if (wall != "lower" && wall != "upper") throw std::runtime_error("no wall \"" + wall + "\"");
  if (!std::isfinite(time) || !std::isfinite(speed)) throw std::runtime_error("an impact is NaN");
  return {time, wall == "upper" ? Wall::upper : Wall::lower, speed};
}

Answer read(const Json& json, const std::string& scene) {
  Answer answer{scene};
  for (const auto& [key, ending] : reasons) {
    if (!json.contains(key)) continue;
    answer.ending = ending;
    answer.reason = one_line(json.at(key).get<std::string>());
    return answer;
  }
  if (json.contains("scene") && json.at("scene") != scene) {
    throw std::runtime_error("an answer for another scene, " + json.at("scene").dump());
  }
  for (const Json& impact : json.at("impacts")) answer.impacts.push_back(impact_in(impact));
  std::ranges::stable_sort(answer.impacts, {}, &Impact::time);
  answer.seconds = json.at("seconds").get<double>();
  answer.deepest = json.value("deepest", 0.0);
  if (!(answer.seconds >= 0) || !(answer.deepest >= 0)) {
    throw std::runtime_error("seconds and deepest must be numbers >= 0");
  }
  return answer;
}

}  // namespace

Answer answer_in(std::string_view line, const std::string& scene) {
  try {
    return read(Json::parse(line), scene);
  } catch (const std::exception& error) {
    return {
        scene, Ending::error,
        one_line(fmt::format("no answer: {}; {}", error.what(), line.substr(0, shown_of_a_line)))};
  }
}

std::string line_of(const Answer& answer) {
  Json json = {{"scene", answer.scene}};
  for (const auto& [key, ending] : reasons) {
    if (answer.ending == ending) json[key] = answer.reason;
  }
  if (answer.ending == Ending::answered) {
    json["impacts"] = report::list_of(answer.impacts, [](const Impact& i) -> Json {
      return {i.time, name_of(i.wall), i.speed};
    });
    json["seconds"] = answer.seconds;
    json["deepest"] = answer.deepest;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json json_of(const ScoredScene& scored) {
  Json line = scored.scene;
  line["impacts"] = report::list_of(scored.truth, [](const TrueImpact& i) -> Json {
    return {i.time, name_of(i.wall), i.speed, i.time_sensitivity, i.speed_sensitivity};
  });
  line["seed"] = scored.seed;
  line["machine"] = write_scene(scored.machine);
  return line;
}

namespace {

constexpr double change =
    1e-10;  // relative, of every number: linear, and far above the oracle's error
constexpr int changes = 3;

/// Everything of the scene but its forces, for the oracle.
Scene track_of(const TestScene& scene) {
  Scene track;
  track.mass = scene.mass;
  track.wall_lower = scene.lower;
  track.wall_upper = scene.upper.value_or(std::numeric_limits<double>::infinity());
  track.restitution_lower = scene.restitution_lower;
  track.restitution_upper = scene.restitution_upper;
  track.friction = 1;
  track.normal_force = scene.friction;
  track.start_position = scene.position;
  track.start_velocity = scene.velocity;
  track.window = Seconds{scene.duration};
  track.counting_limit = scene.slowest;
  return track;
}

TermPush push_of(const TestScene& scene) {
  std::vector<TermPush::Piece> pieces;
  const long double mass = scene.mass;
  for (const ForceSegment& segment : scene.force) {
    TermPush::Piece piece{segment.from, {}};
    for (const ForceTerm& term : segment.terms) {
      const auto& [a, p] = term;
      piece.terms.push_back({{a[0] / mass, a[1] / mass, a[2] / mass}, {p[0], p[1], p[2]}});
    }
    pieces.push_back(std::move(piece));
  }
  return TermPush(std::move(pieces), scene.duration);
}

/// The scene with every number changed by up to `change` of itself, at random; the start by as much
/// of the gap. Times are kept.
TestScene changed(TestScene scene, Random& random) {
  const auto vary = [&](double& x) { x *= 1 + change * (2 * uniform(random) - 1); };
  vary(scene.mass);
  const double lower = scene.lower;
  double start = scene.position - lower;
  if (scene.upper) {
    double gap = *scene.upper - lower;
    const double share = start / gap;
    vary(gap);
    scene.upper = lower + gap;
    start = share * gap;
  }
  vary(start);
  scene.position = lower + start;
  if (scene.upper) scene.position = std::min(scene.position, *scene.upper);
  vary(scene.velocity);
  vary(scene.restitution_lower);
  vary(scene.restitution_upper);
  scene.restitution_lower = std::min(scene.restitution_lower, 1.0);
  scene.restitution_upper = std::min(scene.restitution_upper, 1.0);
  vary(scene.friction);
  for (ForceSegment& segment : scene.force) {
    for (ForceTerm& term : segment.terms) {
      for (double& x : term.amplitude) vary(x);
      for (double& x : term.phase) vary(x);
    }
  }
  return scene;
}

std::optional<std::vector<Impact>> faster_than(double speed, const TestScene& scene) {
  const OracleRun run = oracle_run(track_of(scene), push_of(scene));
  if (!run.finished) return std::nullopt;
  std::vector<Impact> impacts;
  std::ranges::copy_if(run.impacts, std::back_inserter(impacts),
                       [&](const Impact& i) { return i.speed > speed; });
  return impacts;
}

/// Sets the sensitivities to at least the differences from the impacts of a changed scene. Returns
/// the number of impacts that both have, in the same order.
std::size_t compare(Truth& truth, const std::vector<Impact>& other, double slowest) {
  std::size_t k = 0;
  for (const Impact& impact : other) {
    const bool same = k < truth.size() && truth[k].wall == impact.wall &&
                      std::abs(truth[k].speed - impact.speed) <= 0.01 * truth[k].speed;
    if (same) {
      TrueImpact& one = truth[k++];
      one.time_sensitivity =
          std::max(one.time_sensitivity, std::abs(one.time - impact.time) / change);
      one.speed_sensitivity =
          std::max(one.speed_sensitivity, std::abs(one.speed - impact.speed) / change);
    } else if (impact.speed > slowest / 2) {
      break;  // an impact that the scene does not have
    }
  }
  return k;
}

}  // namespace

std::optional<std::vector<Impact>> exact_impacts(const TestScene& scene) {
  return faster_than(scene.slowest / 2, scene);
}

std::optional<Conditioned> conditioned_truth(const TestScene& scene, Random& random) {
  const auto impacts = exact_impacts(scene);
  if (!impacts) return std::nullopt;
  Conditioned result{{}, scene.duration};
  for (const Impact& i : *impacts) result.impacts.push_back({i.time, i.wall, i.speed, 0, 0});
  std::size_t good = result.impacts.size();
  for (int k = 0; k < changes; ++k) {
    // A little slower ones too, for a change may move a speed across the limit.
    const auto other = faster_than(0.499 * scene.slowest, changed(scene, random));
    if (!other) return std::nullopt;
    good = std::min(good, compare(result.impacts, *other, scene.slowest));
  }
  const double most = most_growth * mean_time_between(scene, result.impacts);
  const auto worse = std::ranges::find_if(
      result.impacts, [&](const TrueImpact& i) { return i.time_sensitivity > most; });
  good = std::min(good, static_cast<std::size_t>(worse - result.impacts.begin()));
  if (good < result.impacts.size()) result.good_until = result.impacts[good].time;
  result.impacts.resize(good);
  return result;
}

double mean_time_between(const TestScene& scene, const Truth& truth) {
  return scene.duration / (scored_impacts(scene, truth) + 1);
}

int scored_impacts(const TestScene& scene, const Truth& truth) {
  return static_cast<int>(
      std::ranges::count_if(truth, [&](const TrueImpact& i) { return i.speed > scene.slowest; }));
}

}  // namespace ricochet::studies::simulators
