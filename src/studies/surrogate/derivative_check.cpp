#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "src/core/difference.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "src/studies/surrogate/study.h"

namespace ricochet::studies::surrogate {

namespace {

constexpr double first_step = 1e-3;   // of the differences, at most, in a box of width 1
constexpr double digits_lost = 1e-3;  // a relative error above this is not due to rounding
constexpr double nothing = 1e-9;      // of the function's magnitude, or of 1, across the whole box

/// Objective and constraints.
Vector all_of(const Values& values) {
  Vector all(1 + values.constraints.size());
  all << values.objective, values.constraints;
  return all;
}

Vector in_units(const Problem& problem, const Vector& point) {
  return problem.lower + point.cwiseProduct(problem.upper - problem.lower);
}

double relative(double exact, double difference) {
  if (exact == difference) return 0;
  return std::abs(exact - difference) / std::max(std::abs(exact), std::abs(difference));
}

Vector random_direction(Random& random, Eigen::Index n) {
  Vector direction(n);
  do {
    for (double& u : direction) u = within(random, -1, 1);
  } while (direction.norm() < 0.1);
  return direction.normalized();
}

struct Group {
  std::string family;
  std::vector<Problem> problems;
};

/// The families with derivatives; problems are smoothed if only the surrogate has derivatives.
std::vector<Group> groups_of(const std::vector<Family>& families) {
  std::vector<Group> groups;
  for (const Family& family : families) {
    Group group{family.name, {}};
    for (const Problem& stated : family.problems) {
      const bool smooths = !stated.differentiate && stated.smoothed;
      Problem problem = smooths ? stated.smoothed(stated.smoothing) : stated;
      if (problem.differentiate) group.problems.push_back(std::move(problem));
    }
    if (!group.problems.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

/// One place of a problem, and a direction there.
struct Place {
  const Problem& problem;
  const Vector& point;  ///< of the unit box
  const Vector& direction;

  /// Slopes of all functions, from steps h and less.
  std::vector<Difference> slopes(double h) const {
    return differences(
        [&](double step) {
          return all_of(problem.evaluate(in_units(problem, point + step * direction)));
        },
        0.0, h);
  }
};

/// Why an exact derivative is not the difference `far` with the first step; `size` is that of the
/// function's value.
const char* cause_of(const Place& place, std::size_t function, double exact, double size,
                     const Difference& far, double reach) {
  // NOTE: written so that NaN is an outlier.
  if (relative(exact, far.slope) <= outlier) return "none";
  const double apart = std::abs(exact - far.slope);
  if (apart <= nothing * std::max(1.0, size)) return "flat";
  if (reach < 4 * first_step) {
    const Difference near = place.slopes(0.25 * reach)[function];
    const double left = std::abs(exact - near.slope);
    if (left <= outlier * std::abs(exact) || left <= 10 * near.error) return "reach";
  }
  const double shorter = place.slopes(0.7 * first_step)[function].slope;
  const double own = std::max(far.error, std::abs(far.slope - shorter));
  return apart <= 10 * own && apart <= digits_lost * std::abs(exact) ? "rounding" : "unexplained";
}

Table empty_table() {
  return {"derivatives",
          {{"family"},
           {"function", "of its"},
           {"problem", "without a known reason: problem"},
           {"at", "at, first coordinate", ".9g", 11},
           {"exact", "exact", ".6g"},
           {"difference", "by differences", ".6g"},
           {"error", "their own error", ".0e"},
           {"reach", "reach", ".0e"},
           {"relative"},
           {"cause"}}};
}

}  // namespace

Table derivatives_at(const std::string& family, const Problem& problem, const Vector& point,
                     const Vector& direction) {
  const Vector at = in_units(problem, point);
  const Derivatives d = problem.differentiate(at);
  const Vector sizes = all_of(d.values).cwiseAbs();
  const Vector scaled = direction.cwiseProduct(problem.upper - problem.lower);
  Vector exact(sizes.size());
  exact << d.gradient.dot(scaled), d.jacobian * scaled;
  const Place place{problem, point, direction};
  const std::vector<Difference> far = place.slopes(first_step);
  Table table = empty_table();
  for (std::size_t k = 0; k < far.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const double reach = d.trust.reach;
    table.add(family, k == 0 ? "objective" : "constraints", problem.name, at[0], exact[i],
              far[k].slope, far[k].error, reach, relative(exact[i], far[k].slope),
              cause_of(place, k, exact[i], sizes[i], far[k], reach));
  }
  return table;
}

Table derivatives(const std::vector<Family>& families, std::size_t points, std::uint64_t seed) {
  const std::vector<Group> groups = groups_of(families);
  Table table = empty_table();
  Progress progress("derivatives", static_cast<double>(groups.size()));
  for (const Group& group : groups) {
    std::vector<Table> found(points / groups.size());
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t k) {
      const Problem& problem = group.problems[k % group.problems.size()];
      Random random(seed ^ seed_of(problem.name, "agreement", 0, static_cast<int>(k)));
      Vector point(problem.dimension());
      for (double& u : point) u = within(random, first_step, 1 - first_step);
      found[k] = derivatives_at(group.family, problem, point,
                                random_direction(random, problem.dimension()));
    });
    for (Table& one : found) {
      for (auto& row : one.rows) table.add_row(std::move(row));
    }
    progress.advance(1);
  }
  return table;
}

void add_derivatives(report::Results& results, const Table& derivatives) {
  const auto summary = [&](const std::vector<std::string>& by) {
    std::vector<Aggregate> aggregates = {
        {{"derivatives"}, "", count_of},
        {{"median", "median", ".1e"}, "relative", quantile_of(0.5)},
        {{"of_10", "0.9 quantile", ".1e"}, "relative", quantile_of(0.9)},
        {{"of_100", "0.99", ".1e"}, "relative", quantile_of(0.99)},
        {{"worst", "largest", ".1e"}, "relative", most_of}};
    for (const char* cause : {"flat", "reach", "rounding", "unexplained"}) {
      aggregates.push_back({{cause}, "cause", [cause](const std::vector<Value>& values) {
                              return value_of(std::ranges::count(values, value_of(cause)));
                            }});
    }
    return aggregated(derivatives, by, aggregates);
  };
  const Table total = summary({});
  const Row all = total[0];
  const Table families = aggregated(derivatives, {"family"}, {});
  results.set("families", families.rows.size());
  results.set("derivatives", all["derivatives"]);
  results.set("derivative-median", all["median"]);
  results.set("derivative-of-100", all["of_100"]);
  results.set("outlier", outlier);
  double outliers = 0;
  for (const char* cause : {"flat", "reach", "rounding", "unexplained"}) {
    results.set(fmt::format("{}-outliers", cause), all[cause]);
    outliers += all.number(cause);
  }
  results.set("outliers", outliers);
  Table unexplained = only(where(derivatives, "cause", value_of("unexplained")),
                           {"problem", "at", "exact", "difference", "error", "reach"});
  unexplained.name = "unexplained";
  results.add(summary({"family", "function"}));
  results.add(std::move(unexplained));
}

}  // namespace ricochet::studies::surrogate
