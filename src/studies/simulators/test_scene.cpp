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

std::array<double, 3> rounded(const std::array<long double, 3>& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
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
  for (const auto& [from, terms] : applied_force(machine)) {
    ForceSegment& segment = scene.force.emplace_back(ForceSegment{static_cast<double>(from), {}});
    for (const auto& [a, p] : terms) segment.terms.push_back({rounded(a), rounded(p)});
  }
  return scene;
}

Scales scales_of(const TestScene& scene) {
  Scales scales;
  double fastest = 1e-9;  // [rad/s]
  for (std::size_t k = 0; k < scene.force.size(); ++k) {
    const double end = k + 1 < scene.force.size() ? scene.force[k + 1].from : scene.duration;
    for (const double u : {0.0, (end - scene.force[k].from) / 2, end - scene.force[k].from}) {
      double force = 0;
      for (const auto& [a, p] : scene.force[k].terms) {
        force += std::abs(polynomial(a, u));
        fastest = std::max(fastest, std::abs(p[1] + 2 * u * p[2]));
      }
      scales.force = std::max(scales.force, force);
    }
  }
  scales.length =
      scene.upper ? *scene.upper - scene.lower : std::max(1e-3, scene.position - scene.lower);
  scales.speed =
      std::max(std::abs(scene.velocity), std::sqrt(2 * scales.force / scene.mass * scales.length));
  scales.step = std::min(scene.duration / 50, 2 * std::numbers::pi / 20 / fastest);
  return scales;
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

Push push_of(const TestScene& scene) {
  std::vector<PushPiece> pieces;
  for (const ForceSegment& segment : scene.force) {
    PushPiece& piece = pieces.emplace_back(PushPiece{segment.from, {}});
    for (const auto& [a, p] : segment.terms) {
      piece.terms.push_back({{a[0], a[1], a[2]}, {p[0], p[1], p[2]}});
    }
  }
  return Push(std::move(pieces), scene.mass, scene.duration);
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
