#include "problems/classic/families.h"

#include <algorithm>
#include <cmath>

#include "problems/classic/classic.h"
#include "problems/classic/least_squares.h"

namespace ricochet::classic {
namespace {

/// A regret relative to the best value, or to 1, that still counts as solved.
constexpr double relative_tolerance = 1e-6;

/// More than any multiplier at the best points of Hock and Schittkowski's: 2279, of problem 64.
constexpr double penalty_weight = 1e4;

/// Those of the problems whose names begin with `prefix`, as questions.
std::vector<Question> asked(const std::vector<Problem>& problems, const std::string& prefix) {
  std::vector<Question> questions;
  for (const Problem& problem : problems) {
    if (!problem.name.starts_with(prefix)) continue;
    const double size = std::max(1.0, std::abs(problem.best_known.value()));
    questions.push_back({.stated = problem,
                         .tolerance = relative_tolerance * size,
                         .penalty_weight = penalty_weight});
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
