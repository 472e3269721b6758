#include "src/contest/twin.h"

#include "src/core/instance.h"
#include "src/core/seed.h"

namespace ricochet::contest {

bool has_twins(const Problem& problem) {
  if (!problem.best_point) return false;
  const Vector& best = *problem.best_point;
  const Vector margin = 0.01 * (problem.upper - problem.lower);
  return ((best - problem.lower).array() > margin.array()).all() &&
         ((problem.upper - best).array() > margin.array()).all();
}

Problem twin(Problem problem, Place place, int number) {
  const Vector best = problem.best_point.value();
  const Vector half = (best - problem.lower).cwiseMin(problem.upper - best);
  if (place == Place::lower_end) problem.lower = best;
  if (place == Place::upper_end) problem.upper = best;
  if (place == Place::middle) {
    problem.lower = best - half;
    problem.upper = best + half;
  }
  if (problem.smoothed) {
    problem.smoothed = [smoothed = problem.smoothed, place, number](double width) {
      return twin(smoothed(width), place, number);
    };
  }
  problem.instance = number;
  Random random(seed_of(problem.name, "twin", number, static_cast<int>(place)));
  problem.start = uniform_point(problem, random);
  problem.start_scales.clear();
  return problem;
}

}  // namespace ricochet::contest
