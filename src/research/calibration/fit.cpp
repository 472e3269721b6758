#include "src/research/calibration/fit.h"

#include <fmt/format.h>

#include <algorithm>

#include "src/research/calibration/best_point.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

/// The seed is part of the name, which alone determines the random numbers.
Problem seeded(const Parameterisation& parameterisation, const Search& search,
               const std::string& left_out) {
  Problem problem = calibration_problem(parameterisation, left_out);
  problem.name += fmt::format("-seed-{}{}", search.seed, left_out);
  return problem;
}

Fit fit_of(const Parameterisation& parameterisation, const BestPoint& best,
           const std::string& left_out) {
  return {parameterisation.interpretation, parameterisation.free,
          constants_at(parameterisation, best.x), best.loss, left_out};
}

void polish(Problem& problem, const Search& search, std::int64_t evaluations, BestPoint& best) {
  improve(problem, search.least_squares, evaluations / 2, best);
  improve(problem, search.local, evaluations / 2, best);
}

}  // namespace

std::string words_of(Unknown constant) {
  std::string words(unknown_parameters()[static_cast<std::size_t>(constant)].name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

Fit fit(const Parameterisation& parameterisation, const Search& search,
        const std::string& left_out) {
  Problem problem = seeded(parameterisation, search, left_out);
  BestPoint best = start_of(problem);
  improve(problem, search.global, search.evaluations * 2 / 3, best);
  polish(problem, search, search.evaluations / 3, best);
  return fit_of(parameterisation, best, left_out);
}

Fit polish(const Parameterisation& parameterisation, const Search& search,
           const std::string& left_out) {
  Problem problem = seeded(parameterisation, search, left_out);
  BestPoint best = start_of(problem);
  polish(problem, search, search.evaluations, best);
  return fit_of(parameterisation, best, left_out);
}

Fit best_within(std::int64_t evaluations, const RunRecord& record,
                const Parameterisation& parameterisation, double loss_of_held) {
  Fit fit{parameterisation.interpretation, parameterisation.free, parameterisation.held,
          loss_of_held, ""};
  for (const Improvement& better : record.trace) {
    if (better.evaluations > evaluations) break;
    if (better.true_values.objective >= fit.loss) continue;
    fit.loss = better.true_values.objective;
    fit.constants = constants_at(parameterisation, better.x);
  }
  return fit;
}

}  // namespace ricochet::studies::calibration
