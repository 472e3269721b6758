#include "problems/classic/families.h"

#include "problems/classic/classic.h"
#include "problems/classic/least_squares.h"

namespace ricochet::classic {
namespace {

/// The classic problems whose names begin with `prefix`.
std::vector<Problem> named(const std::string& prefix) {
  std::vector<Problem> problems;
  for (Problem& problem : classic_problems()) {
    if (problem.name.rfind(prefix, 0) == 0) problems.push_back(std::move(problem));
  }
  return problems;
}

Family test_functions() {
  Family family;
  family.name = family.judged_as = "classic";
  family.title = "Test functions of the literature";
  family.question = "Does a solver find the known minimum of a well-known function?";
  family.formula =
      "One function each, smooth or not, with one valley or many; the source of each is in its "
      "problem.";
  family.derivatives = "Exact, but for the step function.";
  family.instances = "One for each function. Some instances are turned about the minimum, too.";
  family.users =
      "Whoever wants to know whether a solver works at all, or to compare with other suites.";
  family.problems = named("classic-");
  return family;
}

Family hock_schittkowski() {
  Family family;
  family.name = family.judged_as = "hs";
  family.title = "Constrained test problems of Hock and Schittkowski";
  family.question = "Does a solver find the known minimum between constraints?";
  family.formula = "The numbered problems of their collection that have no equality constraints.";
  family.constraints = "Inequalities, as many as the problem has.";
  family.derivatives = "Exact.";
  family.instances = "One for each problem.";
  family.users = "Authors of solvers of constrained problems.";
  family.problems = named("hs-");
  return family;
}

Family least_squares() {
  Family family;
  family.name = family.judged_as = "least-squares";
  family.title = "The 53 least-squares problems of Moré and Wild";
  family.question = "Does a solver fit a model whose best fit is known?";
  family.formula =
      "Half the sum of squares of residuals: 22 functions, several sizes and starts. \"far\" is a "
      "start ten times as far out.";
  family.derivatives = "Exact, of the residuals, too.";
  family.instances = "One for each of the 53.";
  family.users = "Authors of solvers of least squares, or without derivatives.";
  family.problems = least_squares_problems();
  return family;
}

}  // namespace

std::vector<Family> families() {
  return {test_functions(), hock_schittkowski(), least_squares()};
}

}  // namespace ricochet::classic
