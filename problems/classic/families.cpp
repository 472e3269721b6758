#include "problems/classic/families.h"

#include <algorithm>
#include <cmath>

#include "problems/classic/classic.h"
#include "problems/classic/least_squares.h"

namespace ricochet::classic {
namespace {

/// A regret relative to the best value, or to 1, that still counts as solved.
constexpr double relative_tolerance = 1e-6;

/// More than any multiplier at the best point: those of Hock and Schittkowski's problems 72 and 99
/// have some of 41,500 and 19,300, no other one of more than 6,400. The best point of 13 has none,
/// and no weight is enough.
double penalty_weight(const Problem& problem) {
  return problem.name == "hs-72" || problem.name == "hs-99" ? 1e5 : 1e4;
}

/// What a gradient takes beside the value [evaluations], about: Question::gradient_cost. Of so many
/// passes of four directions each takes as long as two values. Measured, for 1 to 5 passes: 0.5 to
/// 1.4, 0.9 to 4.3, 2.8 to 6.0, 5.0 to 6.7 and 5.2: `ricochet bench
/// --benchmark_filter=gradient-cost`.
std::int64_t gradient_cost(const Problem& problem) {
  const std::int64_t passes = (problem.dimension() + 3) / 4;
  return 2 * passes - 1;
}

/// Those of the problems whose names begin with `prefix`, as questions.
std::vector<Question> asked(const std::vector<Problem>& problems, const std::string& prefix) {
  std::vector<Question> questions;
  for (const Problem& problem : problems) {
    if (!problem.name.starts_with(prefix)) continue;
    const double size = std::max(1.0, std::abs(problem.best_known.value()));
    questions.push_back({.stated = problem,
                         .tolerance = relative_tolerance * size,
                         .penalty_weight = penalty_weight(problem),
                         .gradient_cost = gradient_cost(problem)});
  }
  return questions;
}

}  // namespace

std::vector<Family> families() {
  return {{"classic", asked(classic_problems(), "classic-")},
          {"hs", asked(classic_problems(), "hs-")},
          {"least-squares", asked(least_squares_problems(), "least-squares-")}};
}

}  // namespace ricochet::classic
