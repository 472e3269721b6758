// The solvers of NLopt, pagmo, dlib, Ipopt and Ceres's L-BFGS: what they reach, and what is special
// of each.

#include <malloc.h>

#include "problems/classic/functions.h"
#include "solvers/library_solvers.h"
#include "solvers/pagmo.h"
#include "src/core/instance.h"
#include "tests/solvers/direct_calls.h"
#include "tests/solvers/solve.h"

namespace ricochet {
namespace {

using Names = std::vector<std::string>;

const Names nlopt_local = {"nlopt-cobyla", "nlopt-bobyqa", "nlopt-nelder-mead", "nlopt-sbplx",
                           "nlopt-slsqp",  "nlopt-mma",    "nlopt-ccsaq",       "nlopt-lbfgs",
                           "nlopt-var2",   "nlopt-tnewton"};
const Names nlopt_global = {"nlopt-direct",      "nlopt-direct-l",   "nlopt-crs2",      "nlopt-ags",
                            "nlopt-mlsl-bobyqa", "nlopt-mlsl-slsqp", "nlopt-mlsl-lbfgs"};
const Names nlopt_constrained = {"nlopt-cobyla", "nlopt-slsqp", "nlopt-mma", "nlopt-ccsaq"};
const Names nlopt_auglag = {"nlopt-auglag-bobyqa", "nlopt-auglag-sbplx", "nlopt-auglag-lbfgs",
                            "nlopt-auglag-mma"};
const Names pagmo_converging = {"pagmo-cmaes", "pagmo-xnes",   "pagmo-de",
                                "pagmo-sade",  "pagmo-de1220", "pagmo-compass-search"};
const Names pagmo_all = {"pagmo-cmaes",  "pagmo-xnes",           "pagmo-de",         "pagmo-sade",
                         "pagmo-de1220", "pagmo-compass-search", "pagmo-cmaes-ipop", "pagmo-gaco"};
const Names pagmo_constrained = {"pagmo-gaco", "pagmo-compass-search", "pagmo-constrained-de"};
const Names dlib_only = {"dlib-global-search"};
const Names ceres_only = {"ceres-lbfgs"};
const Names ipopts = {"ipopt", "ipopt-tuned", "ipopt-exact"};

/// The best objective of a feasible point that solvers reach, and the reasons with which a first
/// start may end before the budget does. Without a reason, any does.
struct Reached {
  Names solvers;
  Problem problem;
  std::int64_t evaluations;
  double best, tolerance;
  std::set<std::string> reasons = {};
};

constexpr double any = infinity;
const std::set<std::string> stopped = {"stopped by the evaluator"};

std::vector<Reached> optima() {
  constexpr double corner = 2 * 30 * 30;  // of sphere(2, 130)
  const double disc_best = -std::sqrt(2.0), arc_best = *arc().best_known;
  const std::set<std::string> not_finite = {"a number is not finite"}, xtol = {"xtol reached"};
  const std::set<std::string> converged = {"converged"}, solved = {"solved"};
  Problem between_infinities = sphere(2, 3);
  between_infinities.true_values = [evaluate = sphere(2, 3).evaluate](const Vector& x) {
    return true_values_of(evaluate(x));
  };
  between_infinities.evaluate = [evaluate = sphere(2, 3).evaluate](const Vector& x) {
    return std::abs(x[0]) > 50 ? Values{x[0] > 0 ? -infinity : infinity, {}} : evaluate(x);
  };
  Problem from_a_corner = sphere(3, 3);
  from_a_corner.start = Vector{{100, -100, 100}};
  return {
      {nlopt_local, sphere(2, 3), 500, 0, 1e-10, {"xtol reached", "success"}},
      {nlopt_local, sphere(2, 130), 500, corner, 1e-3},
      {nlopt_local, half_a_number(), 300, 0, any, not_finite},
      {nlopt_constrained, disc(), 500, disc_best, 1e-6, xtol},
      {{"nlopt-cobyla", "nlopt-slsqp"}, arc(), 500, arc_best, 1e-5},
      {nlopt_auglag, disc(), 5000, disc_best, 1e-6},
      {nlopt_auglag, arc(), 5000, arc_best, 1e-5},
      {nlopt_global, half_a_number(), 300, 0, any, stopped},
      {{"nlopt-isres", "nlopt-esch"}, half_a_number(), 300, 0, any, stopped},
      // A hollow at every point of whole numbers: those next to the lowest have 1.
      {nlopt_global, classic::rastrigin(2), 4000, 0, 0.05},
      {{"nlopt-esch"}, classic::rastrigin(2), 4000, 0, 0.3},
      {{"nlopt-isres"}, classic::rastrigin(2), 4000, 0, 2},
      {pagmo_converging, sphere(2, 3), 4000, 0, 1e-10, converged},
      {{"pagmo-cmaes-ipop", "pagmo-gaco"}, sphere(2, 3), 4000, 0, 1e-10},
      {pagmo_all, sphere(2, 130), 3000, corner, 1e-3},
      {pagmo_all, half_a_number(), 2000, 0, 1e-6},
      {pagmo_all, between_infinities, 2000, 0, 1e-6},
      {pagmo_constrained, disc(), 6000, disc_best, 0.02},
      {{"pagmo-cmaes"}, classic::rosenbrock(5), 5000, 0, 1e-8},
      {{"pagmo-sade"}, classic::rosenbrock(5), 30000, 0, 1e-3},
      {{"pagmo-cmaes"}, sphere(5, -20), 2500, 0, 1e-8},
      {{"pagmo-sade"}, sphere(5, -20), 8000, 0, 1e-8},
      {{"pagmo-sade"}, classic::rastrigin(2), 3000, 0, 1e-8},
      // By growing populations.
      {{"pagmo-cmaes-ipop-tuned"}, classic::rastrigin(5), 40'000, 0, 1e-8},
      {dlib_only, sphere(2, 3), 60, 0, 1e-6},  // it models a quadratic function
      {dlib_only, sphere(5, -20), 200, 0, 1e-6},
      {dlib_only, sphere(2, 130), 100, corner, 1e-3},
      {dlib_only, classic::rastrigin(1), 150, 0, 1e-3},
      {dlib_only, half_a_number(), 100, 0, 1e-4},
      {ceres_only, from_a_corner, 1000, 0, 1e-12, converged},
      {ceres_only, sphere(2, 130), 300, corner, 1e-6},
      {ceres_only, never_a_number(2), 30, 0, any, {"failure"}},
      {ipopts, sphere(4, 3), 300, 0, 1e-12, solved},
      {ipopts, sphere(2, 130), 300, corner, 1e-2},
      {ipopts, disc(), 300, disc_best, 1e-6, solved},
      {ipopts, arc(), 300, arc_best, 1e-6, solved},
  };
}

/// Of the library of this name.
class Adapters : public testing::TestWithParam<const char*> {};

TEST_P(Adapters, ReachTheseOptima) {
  // Run 0 begins at the problem's start, run 1 elsewhere.
  const int number = std::set<std::string>{"pagmo", "dlib"}.contains(GetParam()) ? 1 : 0;
  for (const auto& [solvers, problem, evaluations, best, tolerance, reasons] : optima()) {
    for (const std::string& name : solvers) {
      if (!name.starts_with(GetParam())) continue;
      SCOPED_TRACE(name + " on " + problem.name);
      const RunRecord record = run(problem, solver_named(name), {evaluations}, number);
      const std::string reason = record.terminations.front().reason;
      EXPECT_TRUE(reasons.empty() || reasons.contains(reason)) << reason;
      // Unless it is stopped it leaves the budget to another start.
      EXPECT_TRUE(reasons.empty() || (record.terminations.size() == 1) == (reasons == stopped));
      if (tolerance == any) continue;
      EXPECT_EQ(best_of(record).violation, 0);
      EXPECT_NEAR(best_of(record).objective, best, tolerance);
      if (reasons.empty()) continue;
      ASSERT_TRUE(record.terminations.front().point);
      const Vector& point = *record.terminations.front().point;
      EXPECT_NEAR(true_values_at(problem, point).objective, best, std::max(tolerance, 2e-8));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Adapters, testing::Values("nlopt", "pagmo", "dlib", "ceres", "ipopt"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(SomeAdapters, ComeNearAnEquation) {
  for (const std::string& name : pagmo_constrained) {
    EXPECT_LT(best_of(run(arc(), solver_named(name), {6000}, 0)).violation, 0.01) << name;
  }
  const TrueValues best = best_of(run(arc(), solver_named("nlopt-isres"), {5000}, 0));
  EXPECT_LT(best.violation, 1e-3);
  EXPECT_NEAR(best.objective, *arc().best_known, 0.5);
}

/// A box and an objective in units that are powers of two, which keep every digit.
Problem in_other_units(const Problem& problem, double box, double objective) {
  Problem other = problem;
  for (Vector* each : {&other.lower, &other.upper, &other.start}) *each *= box;
  other.evaluate = [=](const Vector& x) {
    return Values{problem.evaluate(x / box).objective * objective, {}};
  };
  differentiate_by(other, [=](const Vector& x) -> Vector {
    return problem.differentiate(x / box).gradient * (objective / box);
  });
  return other;
}

TEST(SomeAdapters, DoNotDependOnTheUnitsOfTheProblemInTheUnitCube) {
  const auto expect_same = [](const Solver& solver, std::int64_t evaluations, double box,
                              double objective) {
    const Problem problem = sphere(2, 3);
    const RunRecord record = run(problem, solver, {evaluations}, 0);
    const RunRecord other = run(in_other_units(problem, box, objective), solver, {evaluations}, 0);
    std::vector<Vector> scaled = points_of(record);
    for (Vector& x : scaled) x *= box;
    EXPECT_EQ(points_of(other), scaled) << solver.name;
    EXPECT_EQ(reasons_of(other), reasons_of(record)) << solver.name;
  };
  for (const std::string& name : nlopt_local) {
    const bool is_unit = coordinates_of(name) == Coordinates::unit;
    expect_same(is_unit ? solver_named(name) : varied(name, name, {{"coordinates", "unit"}}), 40,
                1024, 1);
  }
  for (const std::string& name : pagmo_all) {
    expect_same(solver_named(name), 1500, 0x1p-20, 0x1p-40);
  }
}

// What reads memory that it has not set finds there what others have left.
TEST(SomeAdapters, RepeatThemselvesWhateverMemoryHolds) {
  const Problem problem = instance(classic::rastrigin(5), 2);
  for (const std::string& name : nlopt_local) {
    std::set<std::string> improved_after;
    for (int filling = 1; filling < 256; filling += 12) {
      mallopt(M_PERTURB, filling);  // of new memory
      std::string evaluations;
      for (const Improvement& step : run(problem, solver_named(name), {1500}, 2).trace) {
        evaluations += fmt::format(" {}", step.evaluations);
      }
      improved_after.insert(evaluations);
    }
    mallopt(M_PERTURB, 0);
    EXPECT_EQ(improved_after.size(), 1U) << name;
  }
}

TEST(Pagmo, AsksForAsManyPointsAGenerationAsItsAlgorithmSays) {
  const struct {
    const char* solver;
    Eigen::Index n;
    std::int64_t asked;
  } cases[] = {{"pagmo-cmaes", 1, 5},  // fewer pagmo refuses
               {"pagmo-cmaes", 2, 6},
               {"pagmo-cmaes", 5, 8},
               {"pagmo-cmaes", 20, 12},  // 4 + 3 log n
               // These look at what they are worth after a second generation.
               {"pagmo-xnes", 1, 2 * 5},
               {"pagmo-xnes", 20, 2 * 12},
               {"pagmo-sade", 1, 2 * 20},  // 10 n within limits
               {"pagmo-sade", 5, 2 * 50},
               {"pagmo-sade", 20, 2 * 100}};
  for (const auto& [solver, n, asked] : cases) {
    const Solved end = solved(plateau(n), solver_named(solver), 1000);
    EXPECT_EQ(end.reason, "converged") << solver;
    EXPECT_EQ(end.ledger.charged, asked) << solver << " " << n;
  }
  // Populations that stay as they are begin some 60 times, in vain.
  EXPECT_GT(end_of(classic::rastrigin(5), pagmo_cmaes(Settings::tuned), 40'000, 1), 0.9);
}

TEST(DlibGlobalSearch, SaysSoWhereNoTwoValuesDiffer) {
  for (const Problem& problem : {plateau(2), never_a_number(2)}) {
    const RunRecord record = run(problem, dlib_global_search(), {1500}, 0);
    EXPECT_EQ(record.terminations.front().reason, "no two values differ");
    EXPECT_EQ(record.terminations.back().reason, "stopped by the evaluator");
    EXPECT_EQ(record.ledger.charged, 1500);
  }
}

TEST(Ipopt, ApproachesABoundFromInside) {
  const RunRecord record = run(sphere(2, 130), ipopt(Settings::tuned), {300}, 0);
  EXPECT_LT(record.trace.back().x.maxCoeff(), 100.0);
}

TEST(SomeSolvers, StopAtWhateverCallTheEvaluatorRefuses) {
  const struct {
    const char* solver;
    Problem problem;
    std::int64_t dearer;  // derivatives than values
  } cases[] = {{"ipopt-tuned", disc(), 2},
               {"ceres-trust-region", suite_problem("least-squares-07-rosenbrock-2x2"), 1},
               {"mads", disc(), 0},
               {"mads-tuned", disc(), 0}};
  for (const auto& [solver, problem, dearer] : cases) {
    SCOPED_TRACE(solver);
    std::int64_t budget = 0;
    for (; budget < 60; ++budget) {
      const Solved end = solved(problem, solver_named(solver), budget);
      if (end.ended == TerminationReason::none) break;  // solved within the budget
      EXPECT_EQ(end.ended, TerminationReason::evaluations);
      EXPECT_EQ(end.reason, "stopped by the evaluator");
      EXPECT_LE(end.ledger.charged, budget);
      EXPECT_GE(end.ledger.charged, budget - dearer);
    }
    EXPECT_GT(budget, 10);
  }
}

// In the process's memory MUMPS finds by chance what it crashes at: several starts find it, too.
TEST(Ipopt, EndsWhereASlopeOfAConstraintIsNotFinite) {
  Problem problem = disc();
  problem.differentiate = [differentiate = problem.differentiate](const Vector& x) {
    Derivatives derivatives = differentiate(x);
    derivatives.jacobian << infinity, quiet_nan;
    return derivatives;
  };
  std::vector<std::string> reasons = reasons_of(run(problem, ipopt(Settings::tuned), {300}, 0));
  ASSERT_GT(reasons.size(), 2U);
  reasons.pop_back();  // stopped by the evaluator
  EXPECT_THAT(reasons, Each("a number is not finite"));
}

TEST(IpoptExact, TakesFewerStepsWhateverTheScalesOfAQuadraticAre) {
  const Ledger exact = solved(sphere(4, 3), ipopt_exact(), 20'000).ledger;
  const Ledger limited = solved(sphere(4, 3), ipopt(Settings::own), 20'000).ledger;
  EXPECT_LT(exact.derivatives, limited.derivatives);
  EXPECT_GT(exact.hessians, 0);
  EXPECT_EQ(limited.hessians, 0);
  const Solved end = solved(classic::ellipsoid(10), ipopt_exact(), 20'000);
  EXPECT_EQ(end.reason, "solved");
  EXPECT_LT(end.best->true_values.objective, 1e-10);
  EXPECT_LT(end.ledger.derivatives, 20);
}

}  // namespace
}  // namespace ricochet
