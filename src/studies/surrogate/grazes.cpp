#include "src/studies/surrogate/grazes.h"

#include <fmt/format.h>
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

/// How the slope behaves at one smoothing parameter.
void add_growth(Table& table, const GrazeStudy& study, std::size_t smoothing) {
  std::size_t growing = 0;
  std::optional<double> least, most, steepest;
  for (const GrazeRow& row : study.rows) {
    if (!row.grows(smoothing)) continue;
    ++growing;
    const double exponent = *row.exponents[smoothing];
    least = std::min(least.value_or(exponent), exponent);
    most = std::max(most.value_or(exponent), exponent);
    const double slope = std::abs(row.approaches[smoothing].back().hit_slope);
    steepest = std::max(steepest.value_or(slope), slope);
  }
  table.add(study.plan.smoothings[smoothing], study.rows.size(), growing,
            study.rows.size() - growing, least, most, steepest);
}

}  // namespace

void add_to(report::Results& results, const GrazeStudy& study) {
  Table grazes{"grazes",
               {{"case"},
                {"omega", "at [rad/s]", ".9f", 11},
                {"wall"},
                {"hit"},
                {"reach_hit", "reach / distance, hit", ".4f"},
                {"reach_missed", "missed", ".4f"}}};
  for (const double smoothing : study.plan.smoothings) {
    grazes.columns.push_back({fmt::format("exponent_{:g}", smoothing),
                              fmt::format("exponent at {:g}", smoothing), ".4f"});
  }
  double reach_error = 0;
  for (const GrazeRow& row : study.rows) {
    const Approach& nearest = row.approaches.front().back();
    std::vector<Value> cells = {value_of(row.id),
                                value_of(row.graze.omega),
                                value_of(row.graze.wall == Wall::upper ? "upper" : "lower"),
                                value_of(row.graze.side > 0 ? "above" : "below"),
                                value_of(nearest.hit_reach / nearest.distance),
                                value_of(nearest.missed_reach / nearest.distance)};
    for (const auto& exponent : row.exponents) cells.push_back(value_of(exponent));
    grazes.add_row(std::move(cells));
    for (const Approach& a : row.approaches.front()) {
      reach_error = std::max({reach_error, std::abs(a.hit_reach / a.distance - 1),
                              std::abs(a.missed_reach / a.distance - 1)});
    }
  }
  Table growth{"graze-growth",
               {{"smoothing", "smoothing parameter", "g"},
                {"grazes"},
                {"growing", "slope grows without limit"},
                {"finite", "slope stays finite"},
                {"least", "exponent, least", ".3f"},
                {"most", "exponent, most", ".3f"},
                {"steepest", "steepest [impacts per rad/s]", ".0f"}}};
  for (std::size_t w = 0; w < study.plan.smoothings.size() && !study.rows.empty(); ++w) {
    add_growth(growth, study, w);
  }
  const auto known = [&](double x) { return study.rows.empty() ? std::nullopt : std::optional(x); };
  results.set("nearest", known(study.plan.distances.back()));
  results.set("farthest", known(study.plan.distances.front()));
  results.set("reach-error", known(reach_error));
  results.set("short-reach", short_reach);
  results.add(std::move(grazes));
  results.add(std::move(growth));
}

}  // namespace ricochet::studies::surrogate
