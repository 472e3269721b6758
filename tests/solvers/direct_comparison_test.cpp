// Every adapter against a direct call of its library on twelve problems of different kinds, from
// the same starts with the same budget, without restarts. The caller works in the problem's own
// coordinates and leaves to the library what the adapter gives no reason to change.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "problems/classic/classic.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/core/instance.h"
#include "tests/solvers/direct_calls.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

constexpr int instances = 4;
constexpr std::int64_t gradient_price = 2;     // evaluations
constexpr std::int64_t evaluations = 100;      // for each variable
constexpr std::int64_t dlib_evaluations = 60;  // its time grows with the square of their number

Problem wanted(const std::string& name, const std::string& formulation) {
  for (const auto& families : {classic::families(), carrier_track::case_families()}) {
    for (const Family& family : families) {
      for (const Problem& problem : family.problems) {
        if (problem.name != name) continue;
        return problem.formulated(problem.formulation_named(formulation));
      }
    }
  }
  throw std::logic_error("no problem " + name);
}

/// With bounds, inequalities, equations; sums of squares; functions with one and many minima; a
/// speed profile; a design.
const std::vector<Problem>& twelve() {
  static const std::vector<Problem> problems = {wanted("hs-5", ""),
                                                wanted("hs-38", ""),
                                                wanted("hs-40", ""),
                                                wanted("hs-43", ""),
                                                wanted("hs-71", ""),
                                                wanted("least-squares-09-helical-valley-3x3", ""),
                                                wanted("least-squares-17-kowalik-osborne-4x11", ""),
                                                wanted("least-squares-25-box-3d-3x10", ""),
                                                wanted("classic-rosenbrock-5", ""),
                                                wanted("classic-hartmann-6", ""),
                                                wanted("profile-wear-4-C2", ""),
                                                wanted("design-count-C5", "penalised-surrogate")};
  return problems;
}

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

/// Of one start.
struct Outcome {
  bool solved = false;
  double spent = 0;  ///< evaluations until solved, or else those of the budget
};

Outcome outcome_of(const RunRecord& record, const Problem& problem, std::int64_t budget) {
  const Verdict verdict = judge(record, problem, problem.tolerance);
  const bool solved = verdict.solved && *verdict.evaluations_to_solve <= budget;
  return {solved, static_cast<double>(solved ? *verdict.evaluations_to_solve : budget)};
}

/// Adapter and library on the same instances.
struct Compared {
  int problems = 0, starts = 0;
  int adapter_solved = 0, library_solved = 0;
  int adapter_first = 0, library_first = 0;  ///< who solved an instance with fewer evaluations
  double adapter_spent = 0, library_spent = 0;
  double farthest = 0;  ///< relative difference of what they spent, the largest of all instances

  void add(const Outcome& adapter, const Outcome& library) {
    ++starts;
    adapter_solved += adapter.solved;
    library_solved += library.solved;
    adapter_spent += adapter.spent;
    library_spent += library.spent;
    const auto rank = [](const Outcome& of) { return of.solved ? of.spent : HUGE_VAL; };
    adapter_first += rank(adapter) < rank(library);
    library_first += rank(library) < rank(adapter);
    farthest = std::max(farthest, std::abs(adapter.spent - library.spent) / library.spent);
  }

  /// Exact sign test, two-sided: the probability of so uneven a number of firsts by chance.
  double p() const {
    const int n = adapter_first + library_first;
    double sum = 0;
    for (int k = 0; k <= std::min(adapter_first, library_first); ++k) {
      sum += std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) -
                      n * std::log(2.0));
    }
    return std::min(1.0, 2 * sum);
  }
};

Compared compared(const Solver& solver) {
  Compared result;
  for (const Problem& stated : twelve()) {
    if (!solver.accepts(stated)) continue;
    ++result.problems;
    for (int number = 1; number <= instances; ++number) {
      const Problem problem = ricochet::instance(stated, number);
      const bool dlib = solver.name.starts_with("dlib");
      const std::int64_t budget = dlib ? dlib_evaluations : evaluations * problem.dimension();
      constexpr double endless = std::numeric_limits<double>::infinity();
      const RunRecord adapter =
          run(problem, without_restarts(solver), {budget, endless, gradient_price}, 0);
      const RunRecord library = run(problem, library_of(solver, problem, budget),
                                    {1'000'000'000, endless, gradient_price}, 0);
      result.add(outcome_of(adapter, problem, budget), outcome_of(library, problem, budget));
    }
  }
  return result;
}

std::vector<Solver> of_libraries() {
  std::vector<Solver> solvers = all_solvers();
  std::erase_if(solvers, [](const Solver& solver) { return !direct_call(solver.name); });
  return solvers;
}

/// What the caller does otherwise than the adapter; empty if nothing that runs depend on.
std::string difference(const Solver& solver) {
  const auto is = [&](std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), solver.name) != names.end();
  };
  if (solver.name == "ceres-lbfgs") return "bounds, which are left out";
  if (solver.name == "pagmo-compass-search") return "first step";
  if (solver.name.starts_with("pagmo-")) return "first population";
  if (solver.name.starts_with("dlib-")) return "first points, samples";
  if (is({"nlopt-cobyla", "nlopt-cobyla-tuned", "nlopt-bobyqa", "nlopt-nelder-mead", "nlopt-sbplx",
          "nlopt-mlsl-bobyqa", "nlopt-auglag-bobyqa", "nlopt-auglag-sbplx"})) {
    return "first step";
  }
  const bool scales_itself =
      is({"nlopt-direct", "nlopt-direct-l", "nlopt-crs2", "nlopt-isres", "nlopt-esch", "nlopt-ags",
          "nlopt-mma", "nlopt-ccsaq", "nlopt-auglag-mma", "ceres-trust-region"});
  const bool own = coordinates_of(solver.name) == Coordinates::own;
  return own || scales_itself ? "" : "coordinates";
}

class DirectComparison : public testing::TestWithParam<Solver> {};

TEST_P(DirectComparison, TheAdapterIsNoWorseThanItsLibrary) {
  const Solver& solver = GetParam();
  const Compared result = compared(solver);
  const std::string other = difference(solver);
  fmt::print(
      "{:22} {:2} problems {:2} starts: solved {:2} {:2}, evaluations {:6.0f} {:6.0f}, first {:2} "
      "{:2}, p {:.3f}, at most {:.0f} % apart, in {} coordinates{}\n",
      solver.name, result.problems, result.starts, result.adapter_solved, result.library_solved,
      result.adapter_spent, result.library_spent, result.adapter_first, result.library_first,
      result.p(), 100 * result.farthest,
      name_of(names_of(Coordinates{}), coordinates_of(solver.name)),
      other.empty() ? "" : "; the caller differs in: " + other);
  EXPECT_GT(result.problems, 1);
  if (other.empty()) {
    EXPECT_EQ(result.adapter_solved, result.library_solved);
    EXPECT_LE(result.farthest, 0.1);  // rounding moves single evaluations
  } else {
    EXPECT_TRUE(result.adapter_first >= result.library_first || result.p() > 0.01);
  }
}

std::string name_of_test(const testing::TestParamInfo<Solver>& tested) {
  return test_name(tested.param.name);
}

INSTANTIATE_TEST_SUITE_P(Of, DirectComparison, testing::ValuesIn(of_libraries()), name_of_test);

}  // namespace
}  // namespace ricochet
