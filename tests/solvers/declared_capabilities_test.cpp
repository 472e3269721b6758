// What every solver declares is true of problems of the suite.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "problems/classic/classic.h"
#include "ricochet/machine.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

/// One to sixteen variables; no constraints, inequalities, an equality, both; with and without
/// derivatives of all orders, residuals and smoothing.
const std::set<std::string> names = {"count-C4",
                                     "top-speed-C1",
                                     "profile-count-8-C4",
                                     "profile-wear-16-C4",
                                     "design-count-C4",
                                     "classic-rosenbrock-5",
                                     "hs-1",
                                     "hs-6",
                                     "hs-10",
                                     "hs-71",
                                     "least-squares-01-linear-full-rank-9x45"};

/// These in every formulation.
std::vector<Problem> sample() {
  std::vector<Problem> problems;
  for (const auto& families : {carrier_track::case_families(), classic::families()}) {
    for (const Family& family : families) {
      for (const Problem& problem : family.problems) {
        if (!names.contains(problem.name)) continue;
        for (const Formulation& formulation : problem.formulations())
          problems.push_back(problem.formulated(formulation));
      }
    }
  }
  return problems;
}

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all = sample();
  return all;
}

/// The problem, smoothed or not, without what `remove` takes away.
Problem without(const Problem& problem, void (*remove)(Problem&)) {
  Problem result = problem;
  if (problem.smoothed) {
    result.smoothed = [smoothed = problem.smoothed, remove](double parameter) {
      return without(smoothed(parameter), remove);
    };
  }
  remove(result);
  return result;
}

/// The problem without one of the things that a solver may need.
std::vector<Problem> bereft(const Problem& problem) {
  return {without(problem, [](Problem& p) { p.differentiate = nullptr; }),
          without(problem, [](Problem& p) { p.lagrangian_hessian = nullptr; }),
          without(problem, [](Problem& p) { p.residuals = nullptr; }),
          without(problem, [](Problem& p) { p.smoothed = nullptr; })};
}

/// Returns true if the solver evaluates points, and neither it nor the problem fails.
bool runs(const Solver& solver, const Problem& problem) {
  const RunRecord record = run(problem, solver, {200}, 0);
  const auto is_refused = [](const SolverTermination& exit) {
    return exit.reason == "invalid arguments";
  };
  return record.failure.empty() && record.ledger.charged > 0 &&
         std::none_of(record.terminations.begin(), record.terminations.end(), is_refused);
}

class DeclaredCapabilities : public testing::TestWithParam<Solver> {};

TEST_P(DeclaredCapabilities, AreEnough) {
  int accepted = 0;
  for (const Problem& problem : problems()) {
    if (!GetParam().accepts(problem)) continue;
    ++accepted;
    EXPECT_TRUE(runs(GetParam(), problem)) << problem.name;
  }
  EXPECT_GT(accepted, 0);
}

TEST_P(DeclaredCapabilities, NameWhatItCannotDoWithout) {
  for (const Problem& problem : problems()) {
    if (!GetParam().accepts(problem)) continue;
    for (const Problem& less : bereft(problem)) {
      EXPECT_EQ(runs(GetParam(), less), GetParam().accepts(less)) << problem.name;
    }
  }
}

TEST(Sample, HasAllItsProblems) {
  std::set<std::string> found;
  for (const Problem& problem : problems()) found.insert(problem.name);
  EXPECT_EQ(found, names);
}

INSTANTIATE_TEST_SUITE_P(Of, DeclaredCapabilities, testing::ValuesIn(all_solvers()),
                         [](const auto& tested) { return test_name(tested.param.name); });

}  // namespace
}  // namespace ricochet
