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

Family test_functions() {
  Family family;
  family.name = "classic";
  family.title = "Test functions of the literature";
  family.asks = "Does a solver find the known minimum of a well-known function?";
  family.formula =
      "One function each, smooth or not, with one valley or many; the source of each is in its "
      "problem.";
  family.derivatives = "Exact, but for the step function.";
  family.instances = "One for each function. Some instances are turned about the minimum, too.";
  family.users =
      "Whoever wants to know whether a solver works at all, or to compare with other suites.";
  family.questions = asked(classic_problems(), "classic-");
  return family;
}

Family hock_schittkowski() {
  Family family;
  family.name = "hs";
  family.title = "Constrained test problems of Hock and Schittkowski";
  family.asks = "Does a solver find the known minimum between constraints?";
  family.formula =
      "33 of the numbered problems of their collection, 6 and 7 with an equation; the others are "
      "not "
      "here yet.";
  family.constraints = "As many as the problem has: inequalities, or one equation.";
  family.derivatives = "Exact.";
  family.instances = "One for each problem.";
  family.users = "Authors of solvers of constrained problems.";
  family.questions = asked(classic_problems(), "hs-");
  return family;
}

Family least_squares() {
  Family family;
  family.name = "least-squares";
  family.title = "The 53 least-squares problems of Moré and Wild";
  family.asks = "Does a solver fit a model whose best fit is known?";
  family.formula =
      "Half the sum of squares of residuals: 22 functions, several sizes and starts. \"far\" is a "
      "start ten times as far out.";
  family.derivatives = "Exact, of the residuals, too.";
  family.instances = "One for each of the 53.";
  family.users = "Authors of solvers of least squares, or without derivatives.";
  family.questions = asked(least_squares_problems(), "least-squares-");
  return family;
}

}  // namespace

std::vector<Family> families() {
  return {test_functions(), hock_schittkowski(), least_squares()};
}

}  // namespace ricochet::classic
