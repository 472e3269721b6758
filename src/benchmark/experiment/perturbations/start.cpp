#include "src/benchmark/experiment/perturbations/start.h"

#include "src/benchmark/experiment/perturbations/draws.h"

namespace ricochet {
namespace {

Vector moved_start(const Problem& problem, std::uint64_t seed) {
  constexpr double length = 1e-3;
  Draws draws(key_of(seed, "perturbed-start"));
  Vector direction(problem.dimension());
  for (double& coordinate : direction) coordinate = draws.normal();
  direction.normalize();
  Vector start = problem.start;
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    const double step = length * direction[i] * (problem.upper[i] - problem.lower[i]);
    const double there = start[i] + step;
    const bool inside = there >= problem.lower[i] && there <= problem.upper[i];
    start[i] = inside ? there : start[i] - step;
  }
  return start;
}

Problem with_start(const Problem& problem, const Vector& start) {
  Problem result = problem;
  result.start = start;
  if (result.start_scales.empty()) result.start_scales = {1.0};
  if (problem.smoothed) {
    result.smoothed = [smoothed = problem.smoothed, start](double width) {
      return with_start(smoothed(width), start);
    };
  }
  return result;
}

}  // namespace

Perturbation perturbed_start() {
  return {"perturbed-start", "the start is moved by 1e-3 of the box in a random direction",
          [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t seed) {
            return with_start(shown, moved_start(shown, seed));
          }};
}

}  // namespace ricochet
