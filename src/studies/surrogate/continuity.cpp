#include "src/studies/surrogate/continuity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/models/observer_pair.h"
#include "problems/carrier_track/paper/cases.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/campaign/progress.h"
#include "src/core/seed.h"
#include "src/studies/surrogate/draws.h"
#include "src/studies/surrogate/largest_jump.h"

namespace ricochet::studies::surrogate {
namespace {

using namespace carrier_track;

/// Counts impacts on another wall than the one before.
struct StrikeCounter : Observer {
  void impact(double /*time*/, Wall wall, double /*speed*/) {
    strikes += last != wall;
    last = wall;
  }
  int strikes = 0;
  std::optional<Wall> last;
};

double strikes_of(const Scene& scene) {
  StrikeCounter counter;
  simulate(scene, counter);
  return counter.strikes;
}

/// Of one simulation.
struct Sums {
  double count = 0, surrogate = 0, strikes = 0;
};

Sums sums_of(const Scene& scene, double width) {
  Sums sums;
  auto add = [&](double z, double left) {
    sums.count += weight(z, left, 0.0);
    sums.surrogate += weight(z, left, width);
  };
  Features<double, decltype(add)> features(scene, add);
  StrikeCounter counter;
  ObserverPair both(features, counter);
  simulate(scene, both);
  sums.strikes = counter.strikes;
  return sums;
}

/// Segments of a case for one of a lively case, whose simulations cost ten times as much.
std::size_t share_of(const Case& a_case) {
  return a_case.restitution > 0.5 ? 1 : 8;
}

}  // namespace

Scene Segment::at(double t) const {
  Scene scene = start;
  scene.omega += t * faster;
  scene.friction += t * rougher;
  scene.restitution_lower += t * livelier;
  scene.restitution_upper += t * livelier;
  scene.wall_upper += t * wider;
  return scene;
}

Segment random_segment(const Scene& scene, Random& random) {
  Segment segment{scene, 0, 0, 0, 0};
  Scene& start = segment.start;
  start.omega = within(random, 1.0, 17.0);
  start.friction *= within(random, 0.75, 1.25);
  const double restitution = within(random, 0.75, 1.05);
  start.restitution_lower *= restitution;
  start.restitution_upper *= restitution;
  start.wall_upper *= within(random, 0.75, 1.25);
  segment.faster = within(random, -0.5, 0.5);
  segment.rougher = within(random, -0.02, 0.02);
  segment.livelier = within(random, -0.05, 0.05);
  segment.wider = within(random, -0.05, 0.05) * start.wall_upper;
  return segment;
}

Jumps jumps_of(const Segment& segment, double width) {
  constexpr int pieces = 16;
  std::vector<double> counts, values, strikes;
  for (int k = 0; k <= pieces; ++k) {
    const Sums sums = sums_of(segment.at(static_cast<double>(k) / pieces), width);
    counts.push_back(sums.count);
    values.push_back(sums.surrogate);
    strikes.push_back(sums.strikes);
  }
  const auto [fewest, most] = std::minmax_element(counts.begin(), counts.end());
  const auto value_at = [&](double t) { return objective(segment.at(t), width); };
  Jumps jumps{*fewest != *most, narrowed(steepest_piece(values), value_at).change(), {}, {}};
  const Piece steepest = steepest_piece(strikes);
  if (steepest.change() > 0) {
    const Piece birth = narrowed(steepest, [&](double t) { return strikes_of(segment.at(t)); });
    const auto change = [&](double distance) {
      return std::abs(value_at(birth.upper + distance) - value_at(birth.lower - distance));
    };
    jumps.at_birth = change(0);
    const double near = change(1e-12);
    if (near > 1e-12) jumps.exponent = 0.5 * std::log10(change(1e-10) / near);
  }
  return jumps;
}

ContinuityStudy study_continuity(const ContinuityPlan& plan) {
  ContinuityStudy study{plan, {}};
  const std::vector<Case> cases = all_cases();
  const std::size_t widths = plan.widths.size();
  std::size_t shares = 0;
  for (const Case& a_case : cases) shares += share_of(a_case);
  Progress progress("continuity", static_cast<double>(cases.size()));
  for (const Case& a_case : cases) {
    ContinuityRow row{a_case.id, plan.segments * share_of(a_case) / shares, 0, {}, {}, {}};
    const Scene scene = scene_of(a_case, default_reading().scene);
    std::vector<Jumps> found(row.segments);
    tbb::parallel_for(std::size_t{0}, row.segments, [&](std::size_t k) {
      Random random(plan.seed ^ seed_of(a_case.id, "continuity", 0, static_cast<int>(k)));
      found[k] = jumps_of(random_segment(scene, random), plan.widths[k % widths]);
    });
    row.jumps.resize(widths);
    row.births.resize(widths);
    for (std::size_t k = 0; k < row.segments; ++k) {
      row.count_jumps += found[k].of_count;
      row.jumps[k % widths].push_back(found[k].surrogate);
      if (found[k].at_birth) row.births[k % widths].push_back(*found[k].at_birth);
      if (found[k].exponent) row.exponents.push_back(*found[k].exponent);
    }
    for (auto& jumps : row.jumps) std::sort(jumps.begin(), jumps.end());
    std::sort(row.exponents.begin(), row.exponents.end());
    for (auto& births : row.births) std::sort(births.begin(), births.end());
    study.rows.push_back(std::move(row));
    progress.advance(1);
  }
  return study;
}

}  // namespace ricochet::studies::surrogate
