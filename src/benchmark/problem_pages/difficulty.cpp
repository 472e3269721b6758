#include "src/benchmark/problem_pages/difficulty.h"

#include <algorithm>
#include <vector>

#include "ricochet/random.h"
#include "src/benchmark/statistics/wilson_interval.h"
#include "src/core/instance.h"
#include "src/core/seed.h"

namespace ricochet::studies::problems {
namespace {

constexpr int points_of_a_plateau = 20;
constexpr double narrowest = 1e-6;  // box widths

/// What is simulated.
Vector simulated(const Problem& problem, const Vector& x) {
  const Values values = problem.evaluate(x);
  return problem.constraints > 0 ? values.constraints : Vector::Constant(1, values.objective);
}

/// The distance from x along a coordinate, in box widths, at which what is simulated changes first:
/// the first of narrowest, twice that and so on where it differs.
double plateau_at(const Problem& problem, const Vector& x, Eigen::Index i) {
  const double width = problem.upper[i] - problem.lower[i];
  const bool up = x[i] - problem.lower[i] < width / 2;  // to the farther end
  const Vector here = simulated(problem, x);
  double distance = narrowest;
  for (; distance < 0.5; distance *= 2) {
    Vector there = x;
    there[i] += (up ? distance : -distance) * width;
    if (simulated(problem, there) != here) break;
  }
  return std::min(distance, 1.0);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

std::optional<Difficulty> difficulty_of(const Problem& problem, int points) {
  if (!problem.best_known) return std::nullopt;
  Random random(seed_of(problem.name, "difficulty", 0, 0));
  int solving = 0, feasible = 0;
  std::vector<double> plateaus;
  for (int k = 0; k < points; ++k) {
    const Vector x = uniform_point(problem, random);
    const TrueValues values = true_values_at(problem, x);
    if (values.violation <= 0) {
      ++feasible;
      if (values.objective <= *problem.best_known + problem.tolerance) ++solving;
    }
    if (k % points_of_a_plateau == 0) {
      plateaus.push_back(plateau_at(problem, x, k / points_of_a_plateau % problem.dimension()));
    }
  }
  const double share = static_cast<double>(solving) / points;
  return Difficulty{share, wilson_interval(solving, points), static_cast<double>(feasible) / points,
                    solving > 0 ? std::optional(1 / share) : std::nullopt, median(plateaus)};
}

}  // namespace ricochet::studies::problems
