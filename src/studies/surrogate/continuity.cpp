#include "src/studies/surrogate/continuity.h"

#include <fmt/format.h>
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
  const char* name;  ///< for readers
  std::vector<std::vector<double>> ContinuityRow::*jumps;
};
constexpr Kind kinds[] = {{"steepest", &ContinuityRow::jumps},
                          {"new strike", &ContinuityRow::births}};

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

/// The weight at a smoothing parameter of an impact with the speed of the last bounces before rest.
double weight_at_rest(double smoothing) {
  return carrier_track::step(
      std::log(carrier_track::resting_speed / carrier_track::default_machine().counting_limit),
      smoothing);
}

/// Number of values above the limit.
std::size_t larger_than(double limit, const std::vector<double>& rising) {
  return static_cast<std::size_t>(rising.end() -
                                  std::upper_bound(rising.begin(), rising.end(), limit));
}

/// Share of the values above limits from 1e-16 to 1, up to the first that none exceeds.
std::vector<report::Sample> tail_of(const std::vector<double>& rising) {
  std::vector<report::Sample> tail;
  for (int k = 0; k <= 64; ++k) {
    const double limit = 1e-16 * std::pow(10.0, 0.25 * k);
    const std::size_t larger = larger_than(limit, rising);
    if (larger == 0) break;
    tail.push_back({limit, static_cast<double>(larger) / static_cast<double>(rising.size())});
  }
  return tail;
}

}  // namespace

void add_to(report::Results& results, const ContinuityStudy& study) {
  std::size_t segments = 0, count_jumps = 0;
  std::vector<double> exponents;
  for (const ContinuityRow& row : study.rows) {
    segments += row.segments;
    count_jumps += row.count_jumps;
    exponents.insert(exponents.end(), row.exponents.begin(), row.exponents.end());
  }
  Table table{"continuity",
              {{"smoothing", "smoothing parameter", "g"},
               {"where", "place"},
               {"segments"},
               {"half", "median", ".1e"},
               {"of_10", "0.9 quantile", ".1e"},
               {"of_100", "0.99", ".1e"},
               {"of_1000", "0.999", ".1e"},
               {"all", "largest", ".1e"}}};
  report::Chart chart{
      .name = "continuity",
      .title = "",
      .x = {"jump of the surrogate [impacts]", report::Scale::logarithmic, report::Range{1e-16, 1}},
      .y = {"share of the jumps", report::Scale::logarithmic},
      .lines = {{report::Direction::vertical, largest_allowed, "allowed"},
                {report::Direction::vertical, 1, "the count's jump"}},
      .width = 640};
  std::size_t births = 0, larger = 0;
  double worst = 0;
  for (std::size_t w = 0; w < study.plan.smoothings.size(); ++w) {
    const double smoothing = study.plan.smoothings[w];
    for (const Kind& kind : kinds) {
      const std::vector<double> jumps = jumps_of(study, kind, w);
      if (jumps.empty()) continue;
      if (kind.jumps == &ContinuityRow::births) births += jumps.size();
      larger += larger_than(largest_allowed, jumps);
      worst = std::max(worst, jumps.back());
      chart.series.push_back(
          {fmt::format("at {:g}, {}", smoothing, kind.name), report::Mark::line, tail_of(jumps)});
      table.add(smoothing, kind.name, jumps.size(), quantile(jumps, 0.5), quantile(jumps, 0.9),
                quantile(jumps, 0.99), quantile(jumps, 0.999), jumps.back());
    }
  }
  chart.title = fmt::format("{} of {} changes between neighbouring numbers are above {:.0e}",
                            larger, segments + births, largest_allowed);
  const double widest = *std::ranges::max_element(study.plan.smoothings);
  results.set("continuous",
              larger == 0 ? fmt::format("Yes, up to rounding: no change between two neighbouring "
                                        "numbers is above {:.0e} impacts.",
                                        largest_allowed)
                          : fmt::format("Not shown: {} changes between two neighbouring numbers "
                                        "are above {:.0e} impacts.",
                                        larger, largest_allowed));
  results.set("jump-worst", worst);
  results.set("segments", segments);
  results.set("count-jumps", static_cast<double>(count_jumps) / static_cast<double>(segments));
  results.set("births", births);
  results.set("resting-speed", carrier_track::resting_speed);
  results.set("widest", widest);
  results.set("weight-at-rest", weight_at_rest(widest));
  results.set("continuity-seed", study.plan.seed);
  using Number = std::optional<double>;
  const bool known = !exponents.empty();
  const auto low = std::ranges::count_if(exponents, [](double p) { return p < 0.4; });
  results.set("exponent-median", known ? Number(quantile(exponents, 0.5)) : Number());
  results.set("exponents-low", low);
  results.set("exponents", exponents.size());
  results.add(std::move(table));
  results.add(std::move(chart));
}

}  // namespace ricochet::studies::surrogate
