#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/motion/observer.h"
#include "problems/carrier_track/suite/machine.h"
#include "src/analysis/statistics/intervals.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "src/studies/surrogate/study.h"

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

/// A row of changes().
std::vector<Value> changes_on(const Segment& segment, double smoothing) {
  constexpr int pieces = 16;
  std::vector<double> counts, values, strikes;
  for (int k = 0; k <= pieces; ++k) {
    const Scene scene = segment(static_cast<double>(k) / pieces);
    counts.push_back(objective(scene, 0.0));
    values.push_back(objective(scene, smoothing));
    strikes.push_back(strikes_of(scene));
  }
  const auto [fewest, most] = std::ranges::minmax(counts);
  const auto value_at = [&](double share) { return objective(segment(share), smoothing); };
  const double steepest = narrowed(steepest_piece(values), value_at).change();
  std::optional<double> at_strike, exponent;
  if (const Piece piece = steepest_piece(strikes); piece.change() > 0) {
    const Piece strike = narrowed(piece, [&](double share) { return strikes_of(segment(share)); });
    const auto change = [&](double distance) {
      return std::abs(value_at(strike.upper + distance) - value_at(strike.lower - distance));
    };
    at_strike = change(0);
    const double near = change(1e-12);
    if (near > 1e-12) exponent = 0.5 * std::log10(change(1e-10) / near);
  }
  return {smoothing, fewest != most, steepest, value_of(at_strike), value_of(exponent)};
}

/// Number of segments of a case for one of a case with many impacts, whose simulations cost ten
/// times as much.
std::size_t share_of(const Case& a_case) {
  return a_case.restitution > 0.5 ? 1 : 8;
}

}  // namespace

Segment random_segment(const Scene& scene, Random& random) {
  Scene start = scene;
  start.omega = within(random, 1.0, 17.0);
  start.friction *= within(random, 0.75, 1.25);
  const double restitution = within(random, 0.75, 1.05);
  start.restitution_lower *= restitution;
  start.restitution_upper *= restitution;
  start.wall_upper *= within(random, 0.75, 1.25);
  const double faster = within(random, -0.5, 0.5), rougher = within(random, -0.02, 0.02),
               livelier = within(random, -0.05, 0.05),
               wider = within(random, -0.05, 0.05) * start.wall_upper;
  return [=](double share) {
    Scene at = start;
    at.omega += share * faster;
    at.friction += share * rougher;
    at.restitution_lower += share * livelier;
    at.restitution_upper += share * livelier;
    at.wall_upper += share * wider;
    return at;
  };
}

Piece steepest_piece(const std::vector<double>& values) {
  const double pieces = static_cast<double>(values.size() - 1);
  Piece steepest{0, 0, values[0], values[0]};
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double end = static_cast<double>(k);
    const Piece piece{(end - 1) / pieces, end / pieces, values[k - 1], values[k]};
    if (k == 1 || piece.change() > steepest.change()) steepest = piece;
  }
  return steepest;
}

Table changes(const std::vector<double>& smoothings, std::size_t segments, std::uint64_t seed) {
  Table table{"changes", columns_named("smoothing,count_jumps,steepest,strike,exponent")};
  const std::vector<Case> cases = all_cases();
  std::size_t shares = 0;
  for (const Case& a_case : cases) shares += share_of(a_case);
  Progress progress("continuity", static_cast<double>(cases.size()));
  for (const Case& a_case : cases) {
    const Scene scene = scene_of(a_case, default_machine());
    const std::size_t first = table.rows.size(), own = segments * share_of(a_case) / shares;
    table.rows.resize(first + own);
    tbb::parallel_for(std::size_t{0}, own, [&](std::size_t k) {
      Random random(seed ^ seed_of(a_case.id, "continuity", 0, static_cast<int>(k)));
      table.rows[first + k] =
          changes_on(random_segment(scene, random), smoothings[k % smoothings.size()]);
    });
    progress.advance(1);
  }
  return table;
}

std::function<Value(const std::vector<Value>&)> quantile_of(double q) {
  return [q](const std::vector<Value>& values) {
    std::vector<double> numbers;
    for (const Value& value : values) {
      if (const auto number = number_in(value)) numbers.push_back(*number);
    }
    return numbers.empty() ? Value() : Value(quantile(std::move(numbers), q));
  };
}

void add_continuity(report::Results& results, const Table& changes) {
  Table table{"continuity"};  // a row for each smoothing parameter and place
  for (const auto& [column, place] :
       {std::pair("steepest", "steepest"), std::pair("strike", "new strike")}) {
    const Table there =
        where(changes, [column = column](const Row& row) { return !is_missing(row[column]); });
    Table part = aggregated(
        there, {"smoothing"},
        {{{"where", "place"}, "", [place = place](const auto&) { return value_of(place); }},
         {{"segments"}, "", count_of},
         {{"half", "median", ".1e"}, column, quantile_of(0.5)},
         {{"of_10", "0.9 quantile", ".1e"}, column, quantile_of(0.9)},
         {{"of_100", "0.99", ".1e"}, column, quantile_of(0.99)},
         {{"of_1000", "0.999", ".1e"}, column, quantile_of(0.999)},
         {{"all", "largest", ".1e"}, column, most_of}});
    table.columns = part.columns;
    for (auto& row : part.rows) table.add_row(std::move(row));
  }
  table.columns.front() = {"smoothing", "smoothing parameter", "g"};
  std::size_t jumps = 0, strikes = 0, larger = 0, low = 0;
  double worst = 0;
  std::vector<Value> exponents;
  each_row(changes, [&](const Row& row) {
    jumps += row.is("count_jumps");
    strikes += !is_missing(row["strike"]);
    const double change = std::max(row.number("steepest"), row.number_if("strike").value_or(0));
    larger += change > largest_allowed;
    worst = std::max(worst, change);
    if (const auto exponent = row.number_if("exponent")) {
      exponents.emplace_back(*exponent);
      low += *exponent < 0.4;
    }
  });
  const Value widest = aggregated(table, {}, {{{"widest"}, "smoothing", most_of}}).rows[0][0];
  results.set("continuous", larger == 0 ? "Yes, up to rounding" : "That is not shown");
  results.set("jumps-larger", larger);
  results.set("largest-allowed", largest_allowed);
  results.set("jump-worst", worst);
  results.set("segments", changes.rows.size());
  results.set("count-jumps", static_cast<double>(jumps) / static_cast<double>(changes.rows.size()));
  results.set("births", strikes);
  results.set("resting-speed", resting_speed);
  results.set("widest", widest);
  results.set("weight-at-rest",
              step(std::log(resting_speed / default_machine().counting_limit), *number_in(widest)));
  results.set("exponent-median", quantile_of(0.5)(exponents));
  results.set("exponents-low", low);
  results.set("exponents", exponents.size());
  results.add(sorted(std::move(table), {"-smoothing"}));
}

}  // namespace ricochet::studies::surrogate
