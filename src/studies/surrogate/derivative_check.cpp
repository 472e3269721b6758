#include "src/studies/surrogate/derivative_check.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <span>

#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/problem.h"
#include "src/analysis/statistics/intervals.h"
#include "src/core/difference.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "src/studies/surrogate/continuity.h"

namespace ricochet::studies::surrogate {

namespace {

/// A relative error above this is not due to rounding.
constexpr double digits_lost = 1e-3;

/// Objective and constraints.
Vector all_of(const Values& values) {
  Vector all(1 + values.constraints.size());
  all << values.objective, values.constraints;
  return all;
}

Vector in_units(const Problem& problem, const Vector& point) {
  return problem.lower + point.cwiseProduct(problem.upper - problem.lower);
}

/// Slopes of all functions at a point of the unit box, from steps h and less.
std::vector<Difference> slopes(const Problem& problem, const Vector& point, const Vector& direction,
                               double h) {
  return differences(
      [&](double step) {
        return all_of(problem.evaluate(in_units(problem, point + step * direction)));
      },
      0.0, h);
}

/// Returns true if a difference with a small error is no further from the exact value than from
/// another difference with shorter steps, or than its estimated error.
bool is_rounding(double exact, const Difference& difference, const Difference& other) {
  const double apart = std::abs(exact - difference.slope);
  const double own = std::max(difference.error, std::abs(difference.slope - other.slope));
  return apart <= 10 * own && apart <= digits_lost * std::abs(exact);
}

/// Returns true if a difference is correct within a share of the slope, or within its estimated
/// error.
bool agrees(double exact, const Difference& difference) {
  const double apart = std::abs(exact - difference.slope);
  return apart <= outlier * std::abs(exact) || apart <= 10 * difference.error;
}

Vector random_direction(Random& random, Eigen::Index n) {
  Vector direction(n);
  do {
    for (double& u : direction) u = within(random, -1, 1);
  } while (direction.norm() < 0.1);
  return direction.normalized();
}

struct Group {
  std::string name;
  std::vector<std::size_t> members;
};

/// Returns the families with derivatives; problems are smoothed if only the surrogate has
/// derivatives.
std::vector<Group> groups_of(const std::vector<Family>& families, std::vector<Problem>& problems) {
  std::vector<Group> groups;
  for (const Family& family : families) {
    Group group{family.name, {}};
    for (const Problem& stated : family.problems) {
      const bool smooths = !stated.differentiate && stated.smoothed;
      const Problem problem = smooths ? stated.smoothed(stated.smoothing) : stated;
      if (!problem.differentiate) continue;
      group.members.push_back(problems.size());
      problems.push_back(problem);
    }
    if (!group.members.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

struct Found {
  Vector point;
  std::vector<Comparison> comparisons;
};

Found look(const Problem& problem, std::size_t index, std::uint64_t seed, std::size_t k) {
  Random random(seed ^ seed_of(problem.name, "agreement", 0, static_cast<int>(k)));
  const Eigen::Index n = problem.dimension();
  Vector point(n);
  for (double& u : point) u = within(random, first_step, 1 - first_step);
  Found found{in_units(problem, point), compare(problem, point, random_direction(random, n))};
  for (Comparison& comparison : found.comparisons) comparison.problem = index;
  return found;
}

}  // namespace

double Comparison::relative() const {
  if (exact == difference) return 0;
  return std::abs(exact - difference) / std::max(std::abs(exact), std::abs(difference));
}

std::vector<Comparison> compare(const Problem& problem, const Vector& point,
                                const Vector& direction) {
  const Derivatives d = problem.differentiate(in_units(problem, point));
  const Vector size = all_of(d.values).cwiseAbs();
  const Vector scaled = direction.cwiseProduct(problem.upper - problem.lower);
  Vector exact(size.size());
  exact << d.gradient.dot(scaled), d.jacobian * scaled;
  std::vector<Difference> found = slopes(problem, point, direction, first_step);
  std::vector<Difference> near;  // within the reach
  std::vector<Comparison> comparisons;
  for (Eigen::Index k = 0; k < exact.size(); ++k) {
    const Difference& far = found[static_cast<std::size_t>(k)];
    Comparison result{0, exact[k], far.slope, far.error, d.trust, Cause::none};
    // NOTE: written so that NaN is an outlier.
    if (!(result.relative() <= outlier)) {
      const bool beyond = d.trust.reach < 4 * first_step;
      if (beyond && near.empty()) {
        near = slopes(problem, point, direction, 0.25 * d.trust.reach);
      }
      if (std::abs(far.slope - exact[k]) <= nothing * std::max(1.0, size[k])) {
        result.cause = Cause::flat;
      } else if (beyond && agrees(exact[k], near[static_cast<std::size_t>(k)])) {
        result.cause = Cause::reach;
      } else if (is_rounding(exact[k], far,
                             slopes(problem, point, direction,
                                    0.7 * first_step)[static_cast<std::size_t>(k)])) {
        result.cause = Cause::rounding;
      } else {
        result.cause = Cause::unexplained;
      }
    }
    comparisons.push_back(result);
  }
  return comparisons;
}

DerivativeCheckStudy study_derivative_check(const DerivativeCheckPlan& plan) {
  DerivativeCheckStudy study;
  study.seed = plan.seed;
  std::vector<Problem> problems;
  const std::vector<Group> families = groups_of(plan.families, problems);
  Progress progress("agreement", static_cast<double>(families.size()));
  for (const Group& family : families) {
    const std::size_t points = plan.points / families.size();
    std::vector<Found> found(points);
    tbb::parallel_for(std::size_t{0}, points, [&](std::size_t k) {
      const std::size_t index = family.members[k % family.members.size()];
      found[k] = look(problems[index], index, plan.seed, k);
    });
    DerivativeErrors objective{family.name, "objective", points, {}, {}};
    DerivativeErrors constraints{family.name, "constraints", points, {}, {}};
    for (const Found& at : found) {
      for (std::size_t function = 0; function < at.comparisons.size(); ++function) {
        const Comparison& comparison = at.comparisons[function];
        DerivativeErrors& row = function == 0 ? objective : constraints;
        row.errors.push_back(comparison.relative());
        ++row.by_cause[static_cast<std::size_t>(comparison.cause)];
        if (comparison.cause != Cause::unexplained) continue;
        study.unexplained.push_back({problems[comparison.problem].name, comparison, at.point});
      }
    }
    study.points += points;
    ++study.families;
    for (DerivativeErrors* row : {&objective, &constraints}) {
      if (row->errors.empty()) continue;
      std::sort(row->errors.begin(), row->errors.end());
      study.rows.push_back(std::move(*row));
    }
    progress.advance(1);
  }
  return study;
}

namespace {

std::size_t outliers_of(const DerivativeErrors& row, Cause cause) {
  return row.by_cause[static_cast<std::size_t>(cause)];
}

void add_row(Table& table, const DerivativeErrors& row) {
  table.add(row.family, row.function, row.points, row.errors.size(), quantile(row.errors, 0.5),
            quantile(row.errors, 0.9), quantile(row.errors, 0.99), quantile(row.errors, 1.0),
            outliers_of(row, Cause::flat), outliers_of(row, Cause::reach),
            outliers_of(row, Cause::rounding), outliers_of(row, Cause::unexplained));
}

}  // namespace

void add_to(report::Results& results, const DerivativeCheckStudy& study) {
  Table table{"derivatives",
              {{"family"},
               {"function", "of its"},
               {"points"},
               {"derivatives"},
               {"median", "median", ".1e"},
               {"of_10", "0.9 quantile", ".1e"},
               {"of_100", "0.99", ".1e"},
               {"worst", "largest", ".1e"},
               {"flat"},
               {"reach", "short reach"},
               {"rounding"},
               {"unexplained"}}};
  DerivativeErrors total{"all", "", study.points, {}, {}};
  for (const DerivativeErrors& row : study.rows) {
    add_row(table, row);
    total.errors.insert(total.errors.end(), row.errors.begin(), row.errors.end());
    for (std::size_t c = 0; c < causes; ++c) total.by_cause[c] += row.by_cause[c];
  }
  std::sort(total.errors.begin(), total.errors.end());
  add_row(table, total);
  Table unexplained{"unexplained",
                    {{"problem", "without a known reason: problem"},
                     {"at", "at, first coordinate", ".9g", 11},
                     {"exact", "exact", ".6g"},
                     {"difference", "by differences", ".6g"},
                     {"error", "their own error", ".0e"},
                     {"reach", "reach", ".0e"}}};
  for (const Outlier& one : study.unexplained) {
    const Comparison& c = one.comparison;
    unexplained.add(one.problem, one.point[0], c.exact, c.difference, c.error, c.trust.reach);
  }
  results.set("points", study.points);
  results.set("families", study.families);
  results.set("derivatives", total.errors.size());
  results.set("derivative-median", quantile(total.errors, 0.5));
  results.set("derivative-of-100", quantile(total.errors, 0.99));
  results.set("outlier", outlier);
  results.set("outliers", total.errors.size() - outliers_of(total, Cause::none));
  results.set("flat-outliers", outliers_of(total, Cause::flat));
  results.set("reach-outliers", outliers_of(total, Cause::reach));
  results.set("rounding-outliers", outliers_of(total, Cause::rounding));
  results.set("unexplained-outliers", unexplained.rows.size());
  results.set("first-step", first_step);
  results.set("steps", Extrapolation<>::levels);
  results.set("nothing", nothing);
  results.set("derivative-seed", study.seed);
  results.add(std::move(table));
  results.add(std::move(unexplained));
}

namespace {

using namespace carrier_track;

constexpr double agreement = 1e-6;   // relative
constexpr double trend_reach = 0.5;  // [rad/s] to either side
constexpr int trend_points = 10;     // to either side

/// The results at one speed.
struct Finding {
  Slope slope;
  double trend;                ///< of the count, by least squares [per rad/s]
  std::vector<double> errors;  ///< relative, of differences of every step
};

double trend_of(const Scene& scene, double omega) {
  double products = 0;
  double squares = 0;
  for (int k = -trend_points; k <= trend_points; ++k) {
    const double shift = trend_reach * k / trend_points;
    const double speed = std::clamp(omega + shift, slowest_speed, fastest_speed);
    products += shift * objective(at_speed(scene, speed), 0.0);
    squares += shift * shift;
  }
  return products / squares;
}

Finding find(const Scene& scene, double omega, double smoothing, const std::vector<double>& steps) {
  const auto value_at = [&](double speed) { return objective(at_speed(scene, speed), smoothing); };
  Finding finding{surrogate_slope(at_speed(scene, omega), smoothing, fastest_speed - slowest_speed),
                  trend_of(scene, omega),
                  {}};
  for (const double share : steps) {
    const double step = share * fastest_speed;
    const double difference = (value_at(omega + step) - value_at(omega - step)) / (2 * step);
    const double error = std::abs(difference - finding.slope.slope);
    const double size = std::max(std::abs(difference), std::abs(finding.slope.slope));
    finding.errors.push_back(size > 0 ? error / size : 0.0);
  }
  return finding;
}

GradientQuality sum_of(std::span<const Finding> findings) {
  GradientQuality quality;
  std::vector<double> reaches;
  for (const Finding& f : findings) {
    ++quality.points;
    const Trust& trust = f.slope.trust;
    ++quality.doubts[static_cast<std::size_t>(trust.doubt)];
    quality.agreeing += std::any_of(f.errors.begin(), f.errors.end(),
                                    [](double error) { return error < agreement; });
    if (f.trend != 0 && trust.doubt != GradientDoubt::flat) {
      ++quality.trending;
      quality.right += (f.trend > 0) == (f.slope.slope > 0);
    }
    reaches.push_back(std::log10(std::min(trust.reach, 1.0)));
  }
  quality.log_reach = quantile(reaches, 0.5);
  return quality;
}

/// At points evenly spaced over the cells, without the ends of each.
std::vector<Finding> findings_of(const Machine& machine, double smoothing,
                                 const GradientDoubtPlan& plan) {
  const int points = plan.cells * plan.points;
  std::vector<Finding> findings(static_cast<std::size_t>(points));
  tbb::parallel_for(0, points, [&](int k) {
    // Starts at half of the first step, so that differences stay above 0.
    const double omega = fastest_speed * (k + 0.5) / points;
    findings[static_cast<std::size_t>(k)] =
        find(machine.scene, std::max(omega, 0.2), smoothing, plan.steps);
  });
  return findings;
}

}  // namespace

GradientDoubtStudy study_gradient_doubt(const GradientDoubtPlan& plan) {
  GradientDoubtStudy study{plan, {}, {}};
  const std::vector<Machine> machines = all_machines();
  Progress progress("gradient validity",
                    static_cast<double>(machines.size() * plan.smoothings.size()));
  const auto size = static_cast<std::size_t>(plan.points);
  for (const double smoothing : plan.smoothings) {
    std::vector<Finding> all;
    for (const Machine& machine : machines) {
      const auto findings = findings_of(machine, smoothing, plan);
      if (smoothing == default_smoothing) {
        CaseQuality& row = study.rows.emplace_back(CaseQuality{machine.id, {}});
        for (std::size_t first = 0; first < findings.size(); first += size) {
          row.cells.push_back(sum_of(std::span(findings).subspan(first, size)));
        }
      }
      all.insert(all.end(), findings.begin(), findings.end());
      progress.advance(1);
    }
    study.by_smoothing.push_back(sum_of(all));
  }
  return study;
}

namespace {

std::optional<double> share(int part, int whole) {
  return whole > 0 ? std::optional(static_cast<double>(part) / whole) : std::nullopt;
}

void add_row(Table& table, double smoothing, const GradientQuality& q) {
  const auto doubted = [&](GradientDoubt doubt) {
    return share(q.doubts[static_cast<std::size_t>(doubt)], q.points);
  };
  table.add(smoothing, q.points, share(q.agreeing, q.points), doubted(GradientDoubt::flat),
            doubted(GradientDoubt::kink), doubted(GradientDoubt::sensitive),
            share(q.right, q.points), share(q.trending - q.right, q.points),
            share(q.points - q.trending, q.points), share(q.right, q.trending),
            std::pow(10.0, q.log_reach));
}

/// Share of right signs by case and speed; a cell without a trend has no value.
report::Chart trend_chart(const GradientDoubtStudy& study, const GradientQuality& all) {
  report::Chart chart{
      .name = "validity-trend",
      .title = fmt::format("The gradient has the sign of the count's trend at {:.0f} % of all "
                           "points; {:.0f} % have no trend or a flat gradient",
                           100 * share(all.right, all.points).value_or(0),
                           100 * share(all.points - all.trending, all.points).value_or(0)),
      .x = {"speed [rad/s]"},
      .y = {"case"},
      .heat_map = report::HeatMap{"same sign [%]", {}, report::Range{0, 100}},
      .height = 360};
  for (int k = 0; k < study.plan.cells; ++k) {
    chart.x.categories.push_back(
        fmt::format("{:.3g}", (k + 0.5) * (fastest_speed / study.plan.cells)));
  }
  for (const CaseQuality& row : study.rows) {
    chart.y.categories.push_back(row.id);
    auto& cells = chart.heat_map->rows.emplace_back();
    for (const GradientQuality& cell : row.cells) {
      cells.push_back(share(100 * cell.right, cell.trending));
    }
  }
  return chart;
}

}  // namespace

void add_to(report::Results& results, const GradientDoubtStudy& study) {
  Table table{"validity",
              {{"smoothing", "smoothing parameter", "g"},
               {"points"},
               {"agreeing", "agrees with differences [%]", ".1%"},
               {"flat", "flat [%]", ".1%"},
               {"kink", "next to a kink [%]", ".1%"},
               {"sensitive", "sensitive [%]", ".1%"},
               {"right", "sign of the count's trend [%]", ".1%"},
               {"wrong", "other sign [%]", ".1%"},
               {"no_trend", "nothing to compare [%]", ".1%"},
               {"trending", "right, of those with a trend [%]", ".1%"},
               {"reach", "median reach, part of the range", ".1e", 4}}};
  for (std::size_t w = 0; w < study.plan.smoothings.size(); ++w) {
    const double smoothing = study.plan.smoothings[w];
    const GradientQuality& q = study.by_smoothing[w];
    add_row(table, smoothing, q);
    if (smoothing != default_smoothing) continue;
    results.set("gradients", q.points);
    results.set("gradients-right", share(q.right, q.points));
    results.set("gradients-wrong", share(q.trending - q.right, q.points));
    results.set("gradients-without-trend", share(q.points - q.trending, q.points));
    results.set("gradients-agreeing", share(q.agreeing, q.points));
    results.set("usual-smoothing", smoothing);
    results.add(trend_chart(study, q));
  }
  results.add(std::move(table));
}

}  // namespace ricochet::studies::surrogate
