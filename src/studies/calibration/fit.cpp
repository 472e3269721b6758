#include "src/studies/calibration/fit.h"

#include <fmt/format.h>

#include "src/studies/calibration/best_point.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

/// With a seed in its name, which alone decides about randomness.
Problem seeded(const Freedom& freedom, const Search& search, const std::string& left_out) {
  Problem problem = calibration_problem(freedom, left_out);
  problem.name += fmt::format("-seed-{}{}", search.seed, left_out);
  return problem;
}

Fit fit_of(const Freedom& freedom, const BestPoint& best, const std::string& left_out) {
  return {freedom.reading, freedom.freed, constants_at(freedom, best.x), best.misfit, left_out};
}

void polish(Problem& problem, const Search& search, std::int64_t evaluations, BestPoint& best) {
  improve(problem, search.least_squares, evaluations / 2, best);
  improve(problem, search.local, evaluations / 2, best);
}

}  // namespace

Fit fit(const Freedom& freedom, const Search& search, const std::string& left_out) {
  Problem problem = seeded(freedom, search, left_out);
  BestPoint best = start_of(problem);
  improve(problem, search.global, search.evaluations * 2 / 3, best);
  polish(problem, search, search.evaluations / 3, best);
  return fit_of(freedom, best, left_out);
}

Fit polish(const Freedom& freedom, const Search& search, const std::string& left_out) {
  Problem problem = seeded(freedom, search, left_out);
  BestPoint best = start_of(problem);
  polish(problem, search, search.evaluations, best);
  return fit_of(freedom, best, left_out);
}

}  // namespace ricochet::studies::calibration
