#include "src/studies/surrogate/grazes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/studies/surrogate/continuity.h"

namespace ricochet::studies::surrogate {

namespace {

using namespace carrier_track;
using report::Json;

constexpr double jump = 0.02;    // of a strike's time, in windows
constexpr double gentle = 1e-3;  // a graze's strike, in limits from which one counts

struct Strikes : Observer {
  void impact(double time, Wall wall, double speed) {
    if (all.empty() || all.back().wall != wall) all.push_back({time, wall, speed});
  }
  std::vector<Impact> all;
};

std::vector<Impact> strikes_at(const Scene& scene, double omega) {
  const Scene there = at_speed(scene, omega);
  Strikes strikes;
  simulate(there, strikes);
  return strikes.all;
}

/// [turns of the plate] of strike k, or the end of the window.
double turns_until(const std::vector<Impact>& strikes, std::size_t k, const Scene& scene,
                   double omega) {
  const double window = duration_of(at_speed(scene, omega));
  return (k < strikes.size() ? strikes[k].time : window) / window;
}

/// Finds the graze where strike k jumps most between two speeds.
std::optional<Graze> graze_within(const Scene& scene, std::size_t k, Piece piece) {
  const Piece end = narrowed(
      piece, [&](double omega) { return turns_until(strikes_at(scene, omega), k, scene, omega); });
  if (end.change() < jump) return std::nullopt;
  const int side = end.at_upper < end.at_lower ? 1 : -1;
  const double omega = side > 0 ? end.upper : end.lower;
  const std::vector<Impact> strikes = strikes_at(scene, omega);
  if (k >= strikes.size() || strikes[k].speed > gentle * scene.counting_limit) return std::nullopt;
  return Graze{omega, side, strikes[k].wall, strikes[k].time};
}

std::optional<double> exponent_of(const std::vector<Approach>& approaches) {
  std::vector<Point> points;
  for (const Approach& a : approaches) {
    const double apart = std::abs(a.hit_slope - a.missed_slope);
    if (a.distance > 1.01e-7 || a.distance < 0.99e-11 || apart == 0) continue;
    points.push_back({std::log(a.distance), std::log(apart)});
  }
  return slope_of(points);
}

}  // namespace

std::vector<Graze> find_grazes(const Scene& scene, double lower, double upper, int steps) {
  std::vector<Graze> grazes;
  double before = lower;
  std::vector<Impact> strikes = strikes_at(scene, lower);
  for (int i = 1; i <= steps; ++i) {
    const double now = lower + (upper - lower) * i / steps;
    std::vector<Impact> next = strikes_at(scene, now);
    for (std::size_t k = 0; k < std::max(strikes.size(), next.size()); ++k) {
      const Piece piece{before, now, turns_until(strikes, k, scene, before),
                        turns_until(next, k, scene, now)};
      if (piece.change() < jump) continue;
      const auto graze = graze_within(scene, k, piece);
      if (!graze) continue;
      grazes.push_back(*graze);
      break;
    }
    before = now;
    strikes = std::move(next);
  }
  return grazes;
}

Approach approach(const Scene& scene, const Graze& graze, double smoothing, double distance) {
  const double step = graze.side * distance * graze_range;
  const Slope hit = surrogate_slope(at_speed(scene, graze.omega + step), smoothing, graze_range);
  const Slope missed = surrogate_slope(at_speed(scene, graze.omega - step), smoothing, graze_range);
  return {distance, hit.slope, missed.slope, hit.trust.reach, missed.trust.reach};
}

GrazeStudy study_grazes(const GrazePlan& plan) {
  GrazeStudy study{plan, {}};
  const std::vector<Case> cases = all_cases();
  std::vector<std::vector<GrazeRow>> found(cases.size());
  tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t c) {
    const Scene scene = scene_of(cases[c], default_machine());
    for (const Graze& graze : find_grazes(scene, 1, 17, plan.steps)) {
      if (found[c].size() == plan.each) break;
      GrazeRow row{cases[c].id, graze, {}, {}};
      for (const double smoothing : plan.smoothings) {
        auto& approaches = row.approaches.emplace_back();
        for (const double distance : plan.distances) {
          const double far = graze.omega + graze_range * distance;
          if (far > graze_range || graze.omega - graze_range * distance <= 0.1) continue;
          approaches.push_back(approach(scene, graze, smoothing, distance));
        }
        row.exponents.push_back(exponent_of(approaches));
      }
      found[c].push_back(std::move(row));
    }
  });
  for (auto& rows : found) {
    study.rows.insert(study.rows.end(), rows.begin(), rows.end());
  }
  return study;
}

namespace {

/// The slopes that are not zero, at one smoothing parameter: of the first graze of each case that
/// is followed by counted impacts, and on the side where the wall is missed, of all of these.
Json slopes_of(const GrazeStudy& study, std::size_t smoothing) {
  Json hits = Json::array(), missed = Json::array();
  const auto add = [](const Approach& at, double slope, Json& rows) {
    if (slope != 0) rows.push_back({{"distance", at.distance}, {"slope", std::abs(slope)}});
  };
  std::string shown;
  for (const GrazeRow& row : study.rows) {
    if (!row.followed() || row.id == shown) continue;
    shown = row.id;
    Json hit = Json::array();
    for (const Approach& at : row.approaches[smoothing]) {
      add(at, at.hit_slope, hit);
      add(at, at.missed_slope, missed);
    }
    hits.push_back({{"id", row.id}, {"omega", row.graze.omega}, {"slopes", std::move(hit)}});
  }
  return {{"number", smoothing + 1},
          {"smoothing", study.plan.smoothings[smoothing]},
          {"hits", std::move(hits)},
          {"missed", std::move(missed)}};
}

Json reaches_of(const GrazeStudy& study) {
  Json reaches = Json::array();
  for (const GrazeRow& row : study.rows) {
    for (const Approach& at : row.approaches.front()) {
      reaches.push_back(
          {{"distance", at.distance}, {"hit", at.hit_reach}, {"missed", at.missed_reach}});
    }
  }
  return reaches;
}

Json data_of(const GrazeRow& row) {
  const Approach& nearest = row.approaches.front().back();
  return {{"id", row.id},
          {"omega", row.graze.omega},
          {"wall", row.graze.wall == carrier_track::Wall::upper ? "upper" : "lower"},
          {"hit", row.graze.side > 0 ? "above" : "below"},
          {"exponents", row.exponents},
          {"reach_hit", nearest.hit_reach / nearest.distance},
          {"reach_missed", nearest.missed_reach / nearest.distance}};
}

}  // namespace

Json data_of(const GrazeStudy& study) {
  Json rows = Json::array();
  std::size_t followed = 0;
  double least = 0;
  double most = -1e300;
  double steepest = 0;
  double missed = 0;
  double reach_error = 0;  // from 1e-6 of the range on
  for (const GrazeRow& row : study.rows) {
    rows.push_back(data_of(row));
    for (const Approach& a : row.approaches.front()) {
      if (a.distance > 1.01e-6) continue;
      reach_error = std::max({reach_error, std::abs(a.hit_reach / a.distance - 1),
                              std::abs(a.missed_reach / a.distance - 1)});
    }
    if (!row.followed()) continue;
    ++followed;
    for (const auto& exponent : row.exponents) {
      least = std::min(least, exponent.value_or(least));
      most = std::max(most, exponent.value_or(most));
    }
    for (const auto& approaches : row.approaches) {
      steepest = std::max(steepest, std::abs(approaches.back().hit_slope));
      missed = std::max(missed, std::abs(approaches.back().missed_slope));
    }
  }
  if (followed == 0) return nullptr;
  Json slopes = Json::array();
  for (std::size_t w = 0; w < study.plan.smoothings.size(); ++w)
    slopes.push_back(slopes_of(study, w));
  return {{"right", std::abs(least + 0.5) < 0.05 && std::abs(most + 0.5) < 0.05},
          {"followed", followed},
          {"all", rows.size()},
          {"least", least},
          {"most", most},
          {"narrowest", study.plan.smoothings.back()},
          {"widest", study.plan.smoothings.front()},
          {"nearest", study.plan.distances.back()},
          {"farthest", study.plan.distances.front()},
          {"steepest", steepest},
          {"missed", missed},
          {"reach_error", reach_error},
          {"short_reach", short_reach},
          {"smoothings", study.plan.smoothings},
          {"rows", std::move(rows)},
          {"slopes", std::move(slopes)},
          {"reaches", reaches_of(study)}};
}

}  // namespace ricochet::studies::surrogate
