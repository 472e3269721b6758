#include "src/studies/surrogate/continuity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/observer.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/analysis/statistics/intervals.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "src/studies/surrogate/derivative_check.h"

namespace ricochet::studies::surrogate {

namespace {

using namespace carrier_track;
using report::Json;

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

/// For one simulation.
struct Sums {
  double count = 0, surrogate = 0, strikes = 0;
};

Sums sums_of(const Scene& scene, double smoothing) {
  Sums sums;
  auto add = [&](double z, double left) {
    sums.count += weight(z, left, 0.0);
    sums.surrogate += weight(z, left, smoothing);
  };
  Features<double, decltype(add)> features(scene, add);
  StrikeCounter counter;
  ObserverPair both(features, counter);
  simulate(scene, both);
  sums.strikes = counter.strikes;
  return sums;
}

/// Number of segments of a case for one of a case with many impacts, whose simulations cost ten
/// times as much.
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

Jumps jumps_of(const Segment& segment, double smoothing) {
  constexpr int pieces = 16;
  std::vector<double> counts, values, strikes;
  for (int k = 0; k <= pieces; ++k) {
    const Sums sums = sums_of(segment.at(static_cast<double>(k) / pieces), smoothing);
    counts.push_back(sums.count);
    values.push_back(sums.surrogate);
    strikes.push_back(sums.strikes);
  }
  const auto [fewest, most] = std::minmax_element(counts.begin(), counts.end());
  const auto value_at = [&](double t) { return objective(segment.at(t), smoothing); };
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
  const std::size_t smoothings = plan.smoothings.size();
  std::size_t shares = 0;
  for (const Case& a_case : cases) shares += share_of(a_case);
  Progress progress("continuity", static_cast<double>(cases.size()));
  for (const Case& a_case : cases) {
    ContinuityRow row{a_case.id, plan.segments * share_of(a_case) / shares, 0, {}, {}, {}};
    const Scene scene = scene_of(a_case, default_machine());
    std::vector<Jumps> found(row.segments);
    tbb::parallel_for(std::size_t{0}, row.segments, [&](std::size_t k) {
      Random random(plan.seed ^ seed_of(a_case.id, "continuity", 0, static_cast<int>(k)));
      found[k] = jumps_of(random_segment(scene, random), plan.smoothings[k % smoothings]);
    });
    row.jumps.resize(smoothings);
    row.births.resize(smoothings);
    for (std::size_t k = 0; k < row.segments; ++k) {
      row.count_jumps += found[k].of_count;
      row.jumps[k % smoothings].push_back(found[k].surrogate);
      if (found[k].at_birth) row.births[k % smoothings].push_back(*found[k].at_birth);
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

namespace {

struct Kind {
  const char* name;
  std::vector<std::vector<double>> ContinuityRow::*jumps;
};
constexpr Kind kinds[] = {{"steepest", &ContinuityRow::jumps}, {"birth", &ContinuityRow::births}};

/// The jumps of all cases at one smoothing parameter, in rising order.
std::vector<double> jumps_of(const ContinuityStudy& study, const Kind& kind,
                             std::size_t smoothing) {
  std::vector<double> all;
  for (const ContinuityRow& row : study.rows) {
    const std::vector<double>& jumps = (row.*kind.jumps)[smoothing];
    all.insert(all.end(), jumps.begin(), jumps.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

Json data_of(const ContinuityRow& row) {
  Json jumps = Json::array();
  for (const auto& of_smoothing : row.jumps) {
    jumps.push_back({{"jump", quantile(of_smoothing, 0.99)}, {"small", nullptr}});
    jumps.push_back(
        {{"jump", of_smoothing.back()}, {"small", of_smoothing.back() <= largest_allowed}});
  }
  return {{"id", row.id},
          {"segments", row.segments},
          {"count_jumps", static_cast<double>(row.count_jumps) / static_cast<double>(row.segments)},
          {"jumps", std::move(jumps)}};
}

/// The weight at a smoothing parameter of an impact with the speed of the last bounces before rest.
double weight_at_rest(double smoothing) {
  return carrier_track::step(
      std::log(carrier_track::resting_speed / carrier_track::default_machine().counting_limit),
      smoothing);
}

}  // namespace

Json data_of(const ContinuityStudy& study) {
  const std::vector<double>& smoothings = study.plan.smoothings;
  const double widest = *std::max_element(smoothings.begin(), smoothings.end());
  Json data = {{"allowed", largest_allowed}, {"resting_speed", carrier_track::resting_speed},
               {"widest", widest},           {"weight_at_rest", weight_at_rest(widest)},
               {"seed", study.plan.seed},    {"columns", Json::array()},
               {"worst", Json::array()},     {"smoothings", Json::array()},
               {"cases", Json::array()},     {"tails", Json::array()}};
  std::size_t births = 0;
  std::size_t larger = 0;
  for (std::size_t w = 0; w < smoothings.size(); ++w) {
    double worst = 0;
    for (const Kind& kind : kinds) {
      const std::vector<double> jumps = jumps_of(study, kind, w);
      if (jumps.empty()) continue;
      if (kind.jumps == &ContinuityRow::births) births += jumps.size();
      larger += larger_than(largest_allowed, jumps);
      worst = std::max(worst, jumps.back());
      data["tails"].push_back(
          {{"smoothing", smoothings[w]}, {"where", kind.name}, {"tail", tail_of(jumps)}});
      data["smoothings"].push_back({{"smoothing", smoothings[w]},
                                    {"where", kind.name},
                                    {"segments", jumps.size()},
                                    {"half", quantile(jumps, 0.5)},
                                    {"of_10", quantile(jumps, 0.9)},
                                    {"of_100", quantile(jumps, 0.99)},
                                    {"of_1000", quantile(jumps, 0.999)},
                                    {"all", jumps.back()},
                                    {"small", jumps.back() <= largest_allowed}});
    }
    data["worst"].push_back({{"smoothing", smoothings[w]}, {"jump", worst}});
    data["columns"].push_back({{"smoothing", smoothings[w]}, {"share", 0.99}});
    data["columns"].push_back({{"smoothing", smoothings[w]}, {"share", nullptr}});
  }
  std::size_t segments = 0;
  std::size_t count_jumps = 0;
  std::vector<double> exponents;
  for (const ContinuityRow& row : study.rows) {
    segments += row.segments;
    count_jumps += row.count_jumps;
    exponents.insert(exponents.end(), row.exponents.begin(), row.exponents.end());
    data["cases"].push_back(data_of(row));
  }
  data["segments"] = segments;
  data["count_jumps"] = static_cast<double>(count_jumps) / static_cast<double>(segments);
  data["births"] = births;
  data["larger"] = larger > 0 ? Json(larger) : Json();
  data["exponents"] = nullptr;
  if (!exponents.empty()) {
    data["exponents"] = {{"median", quantile(exponents, 0.5)},
                         {"low", std::count_if(exponents.begin(), exponents.end(),
                                               [](double p) { return p < 0.4; })},
                         {"all", exponents.size()}};
  }
  return data;
}

report::Json tail_of(const std::vector<double>& rising) {
  report::Json tail = report::Json::array();
  for (int k = 0; k <= 64; ++k) {
    const double limit = 1e-16 * std::pow(10.0, 0.25 * k);
    const std::size_t larger = larger_than(limit, rising);
    if (larger == 0) break;
    tail.push_back({{"limit", limit},
                    {"share", static_cast<double>(larger) / static_cast<double>(rising.size())}});
  }
  return tail;
}

std::size_t larger_than(double limit, const std::vector<double>& rising) {
  return static_cast<std::size_t>(rising.end() -
                                  std::upper_bound(rising.begin(), rising.end(), limit));
}

}  // namespace ricochet::studies::surrogate
