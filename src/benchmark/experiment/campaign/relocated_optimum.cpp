#include "src/benchmark/experiment/campaign/relocated_optimum.h"

#include <algorithm>

#include "src/core/instance.h"
#include "src/core/seed.h"

namespace ricochet {

const std::vector<std::string>& names_of_places() {
  static const std::vector<std::string> names = {"optimum-at-lower-end", "optimum-in-middle",
                                                 "optimum-at-upper-end"};
  return names;
}

std::optional<OptimumPlace> place_named(const std::string& perturbation) {
  const auto& names = names_of_places();
  const auto found = std::find(names.begin(), names.end(), perturbation);
  if (found == names.end()) return std::nullopt;
  return static_cast<OptimumPlace>(found - names.begin());
}

bool can_be_relocated(const Problem& problem) {
  if (!problem.best_point) return false;
  const Vector& best = *problem.best_point;
  const Vector margin = 0.01 * (problem.upper - problem.lower);
  return ((best - problem.lower).array() > margin.array()).all() &&
         ((problem.upper - best).array() > margin.array()).all();
}

Problem relocated(Problem problem, OptimumPlace place, int number) {
  const Vector best = problem.best_point.value();
  const Vector half = (best - problem.lower).cwiseMin(problem.upper - best);
  if (place == OptimumPlace::lower_end) problem.lower = best;
  if (place == OptimumPlace::upper_end) problem.upper = best;
  if (place == OptimumPlace::middle) {
    problem.lower = best - half;
    problem.upper = best + half;
  }
  if (problem.smoothed) {
    problem.smoothed = [smoothed = problem.smoothed, place, number](double smoothing) {
      return relocated(smoothed(smoothing), place, number);
    };
  }
  problem.instance = number;
  Random random(seed_of(problem.name, "relocated optimum", number, static_cast<int>(place)));
  problem.start = uniform_point(problem, random);
  problem.start_scales.clear();
  return problem;
}

}  // namespace ricochet
