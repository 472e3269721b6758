#include "src/live/race.h"

#include <cmath>
#include <stdexcept>

#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/evaluator.h"
#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "solvers/fireworks/fireworks.h"
#include "solvers/library_solvers.h"
#include "src/core/evaluator.h"
#include "src/live/count_there.h"

namespace ricochet::live {
namespace {

using carrier_track::slowest_speed;

Solver solver_of(Racer racer) {
  switch (racer) {
    case Racer::fireworks:
      return fireworks::fireworks("fireworks-paper", fireworks::paper_options());
    case Racer::random_search:
      return random_search();
    case Racer::bisection:
      return bisection();
  }
  throw std::logic_error("there is no such racer");
}

bool is_quiet(const Race& race, double omega) {
  return count_there(at_speed(race.machine, omega)) <= race.quiet_limit;
}

/// The fastest quiet speed, as suite/speed_problems.h has it; its evaluations are added to `steps`.
Problem problem_of(Racer racer, const Race& race, std::vector<RaceStep>& steps) {
  Problem problem;
  problem.name = "top-speed";
  problem.lower = Vector::Constant(1, slowest_speed);
  problem.upper = Vector::Constant(1, race.fastest);
  problem.start = (problem.lower + problem.upper) / 2;
  problem.constraints = 1;
  problem.evaluate = [&race, &steps](const Vector& x) {
    const int count = count_there(at_speed(race.machine, x[0]));
    steps.push_back({x[0], count, -x[0]});
    return Values{-x[0], Vector::Constant(1, count - std::floor(race.quiet_limit))};
  };
  if (racer == Racer::bisection) return problem;
  // No gain of speed in the box outweighs half a collision.
  Problem alone = penalised(problem, 2 * race.fastest);
  alone.evaluate = [evaluate = alone.evaluate, &steps](const Vector& x) {
    Values values = evaluate(x);
    steps.back().value = values.objective;
    return values;
  };
  return alone;
}

}  // namespace

std::vector<RaceStep> steps_of(Racer racer, const Race& race, std::uint64_t seed) {
  std::vector<RaceStep> steps;
  const Problem problem = problem_of(racer, race, steps);
  Evaluator evaluator(problem, Budget{race.evaluations});
  const Solver solver = solver_of(racer);
  Random random(seed);
  Vector start = problem.start;
  while (!evaluator.over()) {
    solver.solve(evaluator, start, random);
    start = uniform_point(problem.lower, problem.upper, random);
  }
  return steps;
}

std::optional<double> goal_of(const Race& race, double step) {
  if (is_quiet(race, race.fastest)) return race.fastest;
  double loud = race.fastest;
  for (double k = std::ceil(race.fastest / step) - 1; k * step >= slowest_speed; --k) {
    double quiet = k * step;
    if (!is_quiet(race, quiet)) {
      loud = quiet;
      continue;
    }
    while (loud - quiet > 1e-9) {
      const double middle = (quiet + loud) / 2;
      (is_quiet(race, middle) ? quiet : loud) = middle;
    }
    return quiet;
  }
  return std::nullopt;
}

}  // namespace ricochet::live
