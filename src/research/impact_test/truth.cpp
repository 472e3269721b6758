#include "src/research/impact_test/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/carrier_track/check/oracle/oracle.h"
#include "src/research/impact_test/match.h"

namespace ricochet::studies::impact_test {
namespace {

using namespace carrier_track;

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

}  // namespace ricochet::studies::impact_test
