#include "src/studies/calibration/fit.h"

#include <fmt/format.h>

#include <stdexcept>

#include "src/core/run.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

/// The best point so far.
struct Best {
  Vector x;
  double misfit;
};

/// Runs a solver from the best point on, and keeps what is better.
void improve(Problem& problem, const Solver& solver, std::int64_t evaluations, Best& best) {
  problem.start = best.x;
  const RunRecord record = run(problem, solver, Budget{evaluations}, 0);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  if (record.trace.empty() || record.trace.back().truth.objective >= best.misfit) return;
  best = {record.trace.back().x, record.trace.back().truth.objective};
}

/// With a seed in its name, which alone decides about randomness.
Problem seeded(const Freedom& freedom, const Search& search, const std::string& left_out) {
  Problem problem = calibration_problem(freedom, left_out);
  problem.name += fmt::format("-seed-{}{}", search.seed, left_out);
  return problem;
}

Best start_of(const Problem& problem) {
  return {problem.start, problem.evaluate(problem.start).objective};
}

Fit fit_of(const Freedom& freedom, const Best& best, const std::string& left_out) {
  return {freedom.reading, freedom.freed, constants_at(freedom, best.x), best.misfit, left_out};
}

void polish(Problem& problem, const Search& search, std::int64_t evaluations, Best& best) {
  improve(problem, search.least_squares, evaluations / 2, best);
  improve(problem, search.local, evaluations / 2, best);
}

}  // namespace

Fit fit(const Freedom& freedom, const Search& search, const std::string& left_out) {
  Problem problem = seeded(freedom, search, left_out);
  Best best = start_of(problem);
  improve(problem, search.global, search.evaluations * 2 / 3, best);
  polish(problem, search, search.evaluations / 3, best);
  return fit_of(freedom, best, left_out);
}

Fit polish(const Freedom& freedom, const Search& search, const std::string& left_out) {
  Problem problem = seeded(freedom, search, left_out);
  Best best = start_of(problem);
  polish(problem, search, search.evaluations, best);
  return fit_of(freedom, best, left_out);
}

}  // namespace ricochet::studies::calibration
