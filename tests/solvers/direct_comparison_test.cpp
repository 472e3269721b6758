// Every adapter against a direct call of its library on twelve problems of different kinds, from
// the same starts with the same budget, without restarts. The caller works in the problem's own
// coordinates and leaves to the library what the adapter gives no reason to change.

#include "src/core/instance.h"
#include "tests/solvers/direct_calls.h"
#include "tests/solvers/solve.h"

namespace ricochet {
namespace {

constexpr int instances = 4;
constexpr std::int64_t gradient_price = 2;      // evaluations
constexpr std::int64_t evaluations_each = 100;  // for each variable
constexpr std::int64_t dlib_evaluations = 60;   // its time grows with the square of their number

/// Ends a run after its first start: an exception does.
Solver without_restarts(Solver solver) {
  solver.solve = [solve = solver.solve](Evaluator& evaluator, const Vector& start,
                                        Random& random) -> SolverTermination {
    solve(evaluator, start, random);
    throw std::runtime_error("one start");
  };
  return solver;
}

/// The library itself, under the solver's name, so that starts and seeds are the same.
Solver library_of(const Solver& solver, const Problem& problem, std::int64_t budget) {
  Solver direct = solver;
  direct.solve = [&problem, name = solver.name, limit = static_cast<int>(budget)](
                     Evaluator& evaluator, const Vector& start, Random& random) {
    Problem posed = problem;
    posed.start = start;
    DirectCall call{posed, evaluator, Coordinates::own, random(), limit};
    if (name.starts_with("ipopt")) call.limit /= 3;  // an iteration costs a value and a gradient
    call.library_chooses = true;
    return SolverTermination{"", direct_call(name)(call)};
  };
  return without_restarts(direct);
}

/// What the adapter, or its library, did on all instances.
struct Side {
  int solved = 0;
  int first = 0;  ///< instances that it solved with fewer evaluations than the other
  double spent = 0;
};

struct Compared {
  int problems = 0, starts = 0;
  Side adapter, library;
  double farthest = 0;  ///< relative difference of what they spent, the largest of all instances

  /// Exact sign test, two-sided: the probability of so uneven a number of firsts by chance.
  double p() const {
    const int n = adapter.first + library.first;
    double sum = 0;
    for (int k = 0; k <= std::min(adapter.first, library.first); ++k) {
      sum += std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) -
                      n * std::log(2.0));
    }
    return std::min(1.0, 2 * sum);
  }
};

Compared compared(const Solver& solver) {
  Compared result;
  // With bounds, inequalities, equations; sums of squares; functions with one and many minima; a
  // speed profile; a design.
  for (const char* name :
       {"hs-5", "hs-38", "hs-40", "hs-43", "hs-71", "least-squares-09-helical-valley-3x3",
        "least-squares-17-kowalik-osborne-4x11", "least-squares-25-box-3d-3x10",
        "classic-rosenbrock-5", "classic-hartmann-6", "profile-wear-4-C2", "design-count-C5"}) {
    Problem stated = suite_problem(name);
    if (stated.name == "design-count-C5") {
      stated = stated.formulated(stated.formulation_named("penalised-surrogate"));
    }
    if (!solver.accepts(stated)) continue;
    ++result.problems;
    for (int number = 1; number <= instances; ++number) {
      ++result.starts;
      const Problem problem = instance(stated, number);
      const bool dlib = solver.name.starts_with("dlib");
      const std::int64_t budget = dlib ? dlib_evaluations : evaluations_each * problem.dimension();
      const auto most = static_cast<double>(budget);
      // Infinite if that is beyond the budget.
      const auto evaluations_to_solve = [&](const Solver& by, std::int64_t allowed) {
        const RunRecord record = run(problem, by, {allowed, infinity, gradient_price}, 0);
        const auto count = judge(record, problem, problem.tolerance).evaluations_to_solve;
        return count && *count <= budget ? static_cast<double>(*count) : infinity;
      };
      const double adapter = evaluations_to_solve(without_restarts(solver), budget);
      const double library =
          evaluations_to_solve(library_of(solver, problem, budget), 1'000'000'000);
      const auto add = [&](Side& side, double own, double other) {
        side.solved += own < infinity;
        side.first += own < other;
        side.spent += std::min(own, most);
      };
      add(result.adapter, adapter, library);
      add(result.library, library, adapter);
      const double of_library = std::min(library, most);
      result.farthest =
          std::max(result.farthest, std::abs(std::min(adapter, most) - of_library) / of_library);
    }
  }
  return result;
}

/// What the caller does otherwise than the adapter; empty if nothing that runs depend on.
std::string difference(const std::string& solver) {
  const std::set<std::string> of_another_step = {
      "pagmo-compass-search", "nlopt-cobyla",        "nlopt-cobyla-tuned",
      "nlopt-bobyqa",         "nlopt-nelder-mead",   "nlopt-sbplx",
      "nlopt-mlsl-bobyqa",    "nlopt-auglag-bobyqa", "nlopt-auglag-sbplx"};
  const std::set<std::string> scaling_themselves = {
      "nlopt-direct", "nlopt-direct-l", "nlopt-crs2",  "nlopt-isres",      "nlopt-esch",
      "nlopt-ags",    "nlopt-mma",      "nlopt-ccsaq", "nlopt-auglag-mma", "ceres-trust-region"};
  if (solver == "ceres-lbfgs") return "bounds, which are left out";
  if (of_another_step.contains(solver)) return "first step";
  if (solver.starts_with("pagmo-")) return "first population";
  if (solver.starts_with("dlib-")) return "first points, samples";
  const bool own = coordinates_of(solver) == Coordinates::own;
  return own || scaling_themselves.contains(solver) ? "" : "coordinates";
}

class DirectComparison : public testing::TestWithParam<Solver> {};

TEST_P(DirectComparison, TheAdapterIsNoWorseThanItsLibrary) {
  const Solver& solver = GetParam();
  const Compared result = compared(solver);
  const std::string other = difference(solver.name);
  fmt::print(
      "{:22} {:2} problems {:2} starts: solved {:2} {:2}, evaluations {:6.0f} {:6.0f}, first {:2} "
      "{:2}, p {:.3f}, at most {:.0f} % apart, in {} coordinates{}\n",
      solver.name, result.problems, result.starts, result.adapter.solved, result.library.solved,
      result.adapter.spent, result.library.spent, result.adapter.first, result.library.first,
      result.p(), 100 * result.farthest,
      name_of(names_of(Coordinates{}), coordinates_of(solver.name)),
      other.empty() ? "" : "; the caller differs in: " + other);
  EXPECT_GT(result.problems, 1);
  if (other.empty()) {
    EXPECT_EQ(result.adapter.solved, result.library.solved);
    EXPECT_LE(result.farthest, 0.1);  // rounding moves single evaluations
  } else {
    EXPECT_TRUE(result.adapter.first >= result.library.first || result.p() > 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, DirectComparison,
                         testing::ValuesIn(solvers_that([](const Solver& solver) {
                           return direct_call(solver.name) != nullptr;
                         })),
                         by_solver);

}  // namespace
}  // namespace ricochet
