// What a solver returns when its budget ends within a search: what its library returns if it is
// called directly with a limit of its own, or the best evaluated point.

#include <ceres/ceres.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlopt.h>

#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "problems/classic/classic.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "solvers/nlopt.h"
#include "src/core/instance.h"
#include "tests/solvers/test_problems.h"

namespace ricochet {
namespace {

Problem classic_problem(const std::string& name, int number) {
  for (const Family& family : classic::families()) {
    for (const Problem& problem : family.problems) {
      if (problem.name == name) return ricochet::instance(problem, number);
    }
  }
  throw std::logic_error("no problem " + name);
}

std::vector<Problem> problems() {
  return {sphere(1, 3),
          limited(7),
          disc(),
          arc(),
          classic_problem("classic-rosenbrock-5", 3),
          classic_problem("hs-26", 1),
          classic_problem("hs-105", 2),
          classic_problem("least-squares-08-rosenbrock-2x2-far", 1)};
}

constexpr int evaluations = 300;  // three times as many with derivatives

std::vector<std::int64_t> tenths(const Solver& solver) {
  const bool slopes = solver.capabilities.derivatives != Capabilities::Order::value;
  std::vector<std::int64_t> budgets = {1, 2, 5};
  for (int k = 1; k <= 10; ++k) budgets.push_back((slopes ? 3 : 1) * evaluations * k / 10);
  return budgets;
}

/// A direct call of a library with a limit: the point that it returned, and what it was charged.
struct Direct {
  Vector x;
  std::int64_t charged = 0;
};

/// The direct call with the largest limit that stays within a budget; nothing if none does. An
/// iteration or evaluation is charged at least `price`.
std::optional<Direct> within(std::int64_t budget, std::int64_t price,
                             const std::function<Direct(int)>& call) {
  std::optional<Direct> found;
  int good = 0, bad = static_cast<int>(budget / price) + 2;
  while (bad - good > 1) {
    const int limit = std::midpoint(good, bad);
    Direct direct = call(limit);
    (direct.charged <= budget ? good : bad) = limit;
    if (direct.charged <= budget) found = std::move(direct);
  }
  return found;
}

/// The problem over the unit cube for NLopt, charged by an evaluator without a limit.
struct Cube {
  Cube(const Problem& of, int maxeval)
      : problem(of), evaluator(problem, {1'000'000'000}), most(maxeval) {}

  /// Once NLopt is at its limit, known points are free: AUGLAG then looks again at the best one.
  Derivatives at(const double* u, bool slopes, Part part) {
    const Vector width = problem.upper - problem.lower;
    const Vector x = problem.lower + width.cwiseProduct(Eigen::Map<const Vector>(u, width.size()));
    const bool known = !known_points.insert({x.begin(), x.end()}).second;
    if (known && objectives > most && !slopes) return {problem.evaluate(x), {}, {}};
    if (!slopes) return {*evaluator.values(x, part), {}, {}};
    Derivatives seen = *evaluator.derivatives(x, part);
    seen.gradient = seen.gradient.cwiseProduct(width);
    seen.jacobian *= width.asDiagonal();
    return seen;
  }

  const Problem& problem;
  Evaluator evaluator;
  int most;
  int objectives = 0;
  std::set<std::vector<double>> known_points;
};

/// Some of the constraints, to be given to NLopt.
struct Rows {
  Cube* cube;
  Eigen::Index first, count;
  Part part;
};

double objective(unsigned n, const double* u, double* gradient, void* data) {
  auto& cube = *static_cast<Cube*>(data);
  ++cube.objectives;
  const Derivatives seen = cube.at(u, gradient, Part::objective);
  if (gradient) Eigen::Map<Vector>(gradient, n) = seen.gradient;
  return seen.values.objective;
}

void constraints(unsigned, double* result, unsigned n, const double* u, double* jacobian,
                 void* data) {
  const Rows& rows = *static_cast<Rows*>(data);
  const Derivatives seen = rows.cube->at(u, jacobian, rows.part);
  Eigen::Map<Vector>(result, rows.count) = seen.values.constraints.segment(rows.first, rows.count);
  if (jacobian) {
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        jacobian, rows.count, n) = seen.jacobian.middleRows(rows.first, rows.count);
  }
}

double largest(unsigned, const double* u, double*, void* data) {
  const Rows& rows = *static_cast<Rows*>(data);
  return rows.cube->at(u, false, rows.part).values.constraints.maxCoeff();
}

Direct nlopt_directly(const NloptAlgorithm& algorithm, const Problem& problem, int maxeval,
                      unsigned long seed) {
  const auto n = static_cast<unsigned>(problem.dimension());
  Cube cube(problem, maxeval);
  Rows equal{&cube, 0, problem.equalities, Part::equalities};
  Rows other{&cube, problem.equalities, problem.constraints - problem.equalities,
             Part::inequalities};
  const auto made = [&](nlopt_algorithm id) {
    nlopt_opt created = nlopt_create(id, n);
    nlopt_set_xtol_abs1(created, algorithm.tolerance);
    nlopt_set_vector_storage(created, static_cast<unsigned>(algorithm.vectors));
    return created;
  };
  nlopt_opt search = made(algorithm.id);
  nlopt_set_lower_bounds1(search, 0);
  nlopt_set_upper_bounds1(search, 1);
  nlopt_set_min_objective(search, objective, &cube);
  const std::vector<double> tolerances(static_cast<std::size_t>(problem.constraints),
                                       constraint_tolerance);
  if (equal.count > 0) {
    nlopt_add_equality_mconstraint(search, static_cast<unsigned>(equal.count), constraints, &equal,
                                   tolerances.data());
  }
  if (other.count > 0 && algorithm.id == NLOPT_GN_AGS) {
    nlopt_add_inequality_constraint(search, largest, &other, constraint_tolerance);
  } else if (other.count > 0) {
    nlopt_add_inequality_mconstraint(search, static_cast<unsigned>(other.count), constraints,
                                     &other, tolerances.data());
  }
  nlopt_set_initial_step1(search, algorithm.initial_step);
  if (algorithm.local) {
    nlopt_opt local = made(*algorithm.local);
    nlopt_set_local_optimizer(search, local);
    nlopt_destroy(local);
  }
  nlopt_set_maxeval(search, maxeval);
  nlopt_srand(seed);
  const Vector width = problem.upper - problem.lower;
  Vector u = (problem.start - problem.lower).cwiseQuotient(width).cwiseMax(0).cwiseMin(1);
  double lowest = 0;
  nlopt_optimize(search, u.data(), &lowest);
  nlopt_destroy(search);
  return {problem.lower + width.cwiseProduct(u), cube.evaluator.ledger().charged};
}

/// The objective over y with x = middle + half sin(y), as Ceres takes no bounds.
class Waves : public ceres::FirstOrderFunction {
 public:
  Waves(const Problem& problem, Evaluator& evaluator) : problem_(problem), evaluator_(evaluator) {}
  int NumParameters() const override { return static_cast<int>(problem_.dimension()); }
  bool Evaluate(const double* parameters, double* cost, double* gradient) const override {
    const Eigen::Map<const Vector> y(parameters, problem_.dimension());
    const Vector half = (problem_.upper - problem_.lower) / 2;
    if (!gradient) {
      *cost = evaluator_.values(at(y), Part::objective)->objective;
    } else {
      const Derivatives seen = *evaluator_.derivatives(at(y));
      *cost = seen.values.objective;
      Eigen::Map<Vector>(gradient, y.size()) =
          seen.gradient.array() * half.array() * y.array().cos();
    }
    return true;
  }
  Vector at(const Vector& y) const {
    return (problem_.lower + problem_.upper) / 2 +
           Vector((problem_.upper - problem_.lower).array() / 2 * y.array().sin());
  }

 private:
  const Problem& problem_;
  Evaluator& evaluator_;
};

Direct ceres_directly(const Problem& problem, int iterations) {
  Evaluator evaluator(problem, {1'000'000'000});
  auto* waves = new Waves(problem, evaluator);
  const ceres::GradientProblem posed(waves);
  const Vector middle = (problem.lower + problem.upper) / 2;
  Vector y = (problem.start - middle).array() / (problem.upper - middle).array();
  y = y.cwiseMax(-0.999).cwiseMin(0.999).array().asin();
  ceres::GradientProblemSolver::Options options;
  options.logging_type = ceres::SILENT;
  options.function_tolerance = 1e-14;
  options.max_num_iterations = iterations - 1;
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(options, posed, y.data(), &summary);
  return {waves->at(y), evaluator.ledger().charged};
}

/// The residuals over the unit cube.
class UnitResiduals : public ceres::CostFunction {
 public:
  UnitResiduals(const Problem& problem, Evaluator& evaluator)
      : problem_(problem), evaluator_(evaluator) {
    set_num_residuals(static_cast<int>(problem.residuals(problem.start).values.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.dimension()));
  }
  bool Evaluate(double const* const* u, double* values, double** jacobians) const override {
    const Vector width = problem_.upper - problem_.lower;
    const Vector x =
        problem_.lower + width.cwiseProduct(Eigen::Map<const Vector>(u[0], width.size()));
    Eigen::Map<Vector> told(values, num_residuals());
    if (!jacobians || !jacobians[0]) {
      told = *evaluator_.residual_values(x);
    } else {
      const Residuals seen = *evaluator_.residuals(x, Part::jacobian);
      told = seen.values;
      Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          jacobians[0], num_residuals(), x.size()) = seen.jacobian * width.asDiagonal();
    }
    return true;
  }

 private:
  const Problem& problem_;
  Evaluator& evaluator_;
};

Direct ceres_least_squares_directly(const Problem& problem, int iterations) {
  Evaluator evaluator(problem, {1'000'000'000});
  const Vector width = problem.upper - problem.lower;
  Vector u = (problem.start - problem.lower).cwiseQuotient(width).cwiseMax(0).cwiseMin(1);
  ceres::Problem posed;
  posed.AddResidualBlock(new UnitResiduals(problem, evaluator), nullptr, u.data());
  for (int i = 0; i < static_cast<int>(u.size()); ++i) {
    posed.SetParameterLowerBound(u.data(), i, 0);
    posed.SetParameterUpperBound(u.data(), i, 1);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.line_search_interpolation_type = ceres::QUADRATIC;
  options.function_tolerance = 1e-14;
  options.gradient_tolerance = 0;
  options.max_num_iterations = iterations - 1;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &posed, &summary);
  return {problem.lower + width.cwiseProduct(u), evaluator.ledger().charged};
}

#ifdef RICOCHET_HAS_IPOPT

/// The problem over the unit cube for Ipopt, charged by an evaluator without a limit.
class CubeForIpopt : public Ipopt::TNLP {
 public:
  using Index = Ipopt::Index;
  using Number = Ipopt::Number;

  CubeForIpopt(const Problem& problem, bool exact)
      : evaluator(problem, {1'000'000'000}), problem_(problem), exact_(exact) {}

  bool get_nlp_info(Index& n, Index& m, Index& slopes, Index& curves,
                    IndexStyleEnum& style) override {
    n = static_cast<Index>(problem_.dimension());
    m = static_cast<Index>(problem_.constraints);
    slopes = n * m;
    curves = exact_ ? n * (n + 1) / 2 : 0;
    style = C_STYLE;
    return true;
  }
  bool get_bounds_info(Index n, Number* lower, Number* upper, Index m, Number* least,
                       Number* most) override {
    std::fill_n(lower, n, 0.0);
    std::fill_n(upper, n, 1.0);
    for (Index i = 0; i < m; ++i) least[i] = i < problem_.equalities ? 0 : -2e19;
    std::fill_n(most, m, 0.0);
    return true;
  }
  bool get_starting_point(Index n, bool, Number* u, bool, Number*, Number*, Index, bool,
                          Number*) override {
    Eigen::Map<Vector>(u, n) = (problem_.start - problem_.lower).cwiseQuotient(width());
    return true;
  }
  bool eval_f(Index n, const Number* u, bool, Number& told) override {
    told = evaluator.values(at(n, u), Part::objective)->objective;
    return true;
  }
  bool eval_grad_f(Index n, const Number* u, bool, Number* told) override {
    const Vector slope = evaluator.derivatives(at(n, u), Part::objective)->gradient;
    Eigen::Map<Vector>(told, n) = slope.cwiseProduct(width());
    return true;
  }
  bool eval_g(Index n, const Number* u, bool, Index m, Number* told) override {
    Eigen::Map<Vector>(told, m) = evaluator.values(at(n, u), both)->constraints;
    return true;
  }
  bool eval_jac_g(Index n, const Number* u, bool, Index m, Index, Index* rows, Index* columns,
                  Number* told) override {
    const Matrix slopes =
        told ? Matrix(evaluator.derivatives(at(n, u), both)->jacobian * width().asDiagonal())
             : Matrix();
    for (Index k = 0; k < n * m; ++k) {
      if (told) {
        told[k] = slopes(k / n, k % n);
      } else {
        rows[k] = k / n;
        columns[k] = k % n;
      }
    }
    return true;
  }
  bool eval_h(Index n, const Number* u, bool, Number factor, Index m, const Number* multipliers,
              bool, Index, Index* rows, Index* columns, Number* told) override {
    const Matrix curves = told ? *evaluator.lagrangian_hessian(
                                     at(n, u), factor, Eigen::Map<const Vector>(multipliers, m))
                               : Matrix();
    for (Index i = 0, k = 0; i < n; ++i) {
      for (Index j = 0; j <= i; ++j, ++k) {
        if (told) {
          told[k] = width()[i] * curves(i, j) * width()[j];
        } else {
          rows[k] = i;
          columns[k] = j;
        }
      }
    }
    return true;
  }
  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* u, const Number*,
                         const Number*, Index, const Number*, const Number*, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    returned = at(n, u);
  }

  Evaluator evaluator;
  Vector returned;

 private:
  static constexpr Part both{static_cast<unsigned>(Part::equalities) |
                             static_cast<unsigned>(Part::inequalities)};

  Vector width() const { return problem_.upper - problem_.lower; }
  Vector at(Index n, const Number* u) const {
    return problem_.lower + width().cwiseProduct(Eigen::Map<const Vector>(u, n));
  }

  const Problem& problem_;
  bool exact_;
};

Direct ipopt_directly(const std::string& solver, const Problem& problem, int iterations) {
  const bool exact = solver == "ipopt-exact";
  const Ipopt::SmartPtr<CubeForIpopt> cube = new CubeForIpopt(problem, exact);
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  const auto options = application->Options();
  if (!exact) options->SetStringValue("hessian_approximation", "limited-memory");
  if (solver == "ipopt-tuned") {
    options->SetStringValue("mu_strategy", "monotone");
    options->SetNumericValue("mu_init", 1e-3);
  }
  options->SetNumericValue("constr_viol_tol", constraint_tolerance);
  options->SetNumericValue("acceptable_constr_viol_tol", constraint_tolerance);
  options->SetNumericValue("bound_relax_factor", 0);
  options->SetIntegerValue("max_iter", iterations - 1);
  application->Initialize("");
  application->OptimizeTNLP(GetRawPtr(cube));
  return {cube->returned, cube->evaluator.ledger().charged};
}

#endif

/// A run that its budget ended within its first search, and the values at the point returned.
std::optional<RunRecord> cut(const Problem& problem, const Solver& solver, std::int64_t budget) {
  RunRecord record = run(problem, solver, {budget}, 0);
  const bool within_first = record.termination_reason == TerminationReason::evaluations &&
                            record.terminations.size() == 1 && record.ledger.charged > 0;
  return within_first ? std::optional(std::move(record)) : std::nullopt;
}

/// The direct call of the solver's library with a limit, if a test has one; `seed` is of the run.
std::function<Direct(int)> library_of(const Solver& solver, const Problem& problem,
                                      std::uint64_t run_seed) {
  for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
    if (solver.name != fmt::format("nlopt-{}", algorithm.name)) continue;
    Random random(run_seed);
    return [algorithm, &problem, seed = random()](int limit) {
      return nlopt_directly(algorithm, problem, limit, seed);
    };
  }
  if (solver.name == "ceres-lbfgs") {
    return [&problem](int limit) { return ceres_directly(problem, limit); };
  }
  if (solver.name == "ceres-trust-region") {
    return [&problem](int limit) { return ceres_least_squares_directly(problem, limit); };
  }
#ifdef RICOCHET_HAS_IPOPT
  if (solver.name.starts_with("ipopt")) {
    return
        [&problem, name = solver.name](int limit) { return ipopt_directly(name, problem, limit); };
  }
#endif
  return nullptr;
}

/// Returns true if the run returned what the library returns with the largest limit that the budget
/// allows, or its best evaluated point if it allows none.
bool as_its_library(const Solver& solver, const Problem& problem, const RunRecord& record) {
  const bool of_evaluations = solver.name.starts_with("nlopt-");  // others limit iterations
  const std::int64_t price = of_evaluations ? 1 : 1 + problem.dimension() / 2;
  const auto direct =
      within(record.budget.evaluations, price, library_of(solver, problem, record.seed));
  const Vector& expected = direct ? direct->x : record.trace.back().x;
  return record.returned && (record.returned->x - expected).norm() <= 1e-12 * (1 + expected.norm());
}

class AtLimitContract : public testing::TestWithParam<Solver> {};
class OwnAtLimitContract : public AtLimitContract {};
class BestAtLimitContract : public AtLimitContract {};

TEST_P(OwnAtLimitContract, WhatTheLibraryReturnsAtItsLimitIsReturned) {
  const Solver& solver = GetParam();
  int compared = 0, moved = 0;
  for (const Problem& problem : problems()) {
    if (!solver.accepts(problem)) continue;
    for (const std::int64_t budget : tenths(solver)) {
      // A call of Ipopt takes milliseconds.
      if (solver.name.starts_with("ipopt") && (budget > 200 || problem.dimension() > 5)) continue;
      const auto record = cut(problem, solver, budget);
      if (!record || record->trace.empty()) continue;
      EXPECT_TRUE(as_its_library(solver, problem, *record)) << problem.name << ", " << budget;
      moved += (record->returned->x - problem.start).norm() > 1e-6;
      ++compared;
    }
  }
  EXPECT_GT(compared, 3);
  EXPECT_GT(moved, 0);
}

// Prints, for each solver, how often the returned point of a run that its budget ended is worse
// than its best evaluated one, and how often it is what its library returns at its own limit:
// twelve problems, ten budgets. Run with
// --gtest_also_run_disabled_tests --gtest_filter='*DISABLED_Table'.
TEST(AtItsLimit, DISABLED_Table) {
  std::vector<Problem> twelve = {sphere(2, 3), disc(), arc()};
  for (const auto& [name, number] :
       {std::pair("classic-rosenbrock-5", 3), std::pair("classic-sphere-5", 2),
        std::pair("classic-rastrigin-5", 1), std::pair("classic-ackley-5", 4),
        std::pair("hs-16", 1), std::pair("hs-26", 1), std::pair("hs-71", 1), std::pair("hs-105", 2),
        std::pair("least-squares-08-rosenbrock-2x2-far", 1)}) {
    twelve.push_back(classic_problem(name, number));
  }
  fmt::print("solver | returns | runs cut | worse than best evaluated | as its library\n");
  for (const Solver& solver : all_solvers()) {
    int cuts = 0, worse = 0, same = 0;
    const bool own = solver.at_limit == AtLimit::own_point;
    for (const Problem& problem : twelve) {
      if (!solver.accepts(problem)) continue;
      for (int k = 1; k <= 10; ++k) {
        const auto record = cut(problem, solver, tenths(solver)[static_cast<std::size_t>(2 + k)]);
        if (!record || record->trace.empty()) continue;
        ++cuts;
        worse += !record->returned ||
                 better(record->trace.back().true_values, record->returned->true_values);
        same += own && as_its_library(solver, problem, *record);
      }
    }
    fmt::print("{} | {} | {} | {} | {}\n", solver.name, own ? "its own point" : "best evaluated",
               cuts, worse, own ? fmt::format("{}", same) : "-");
  }
}

TEST_P(BestAtLimitContract, TheBestEvaluatedPointIsReturned) {
  const Solver& solver = GetParam();
  int compared = 0;
  std::vector<Problem> all = problems();
  all.push_back(half_a_number());
  for (const Problem& problem : all) {
    if (!solver.accepts(problem)) continue;
    for (const std::int64_t budget : tenths(solver)) {
      const auto record = cut(problem, solver, budget);
      if (!record || record->trace.empty()) continue;
      ASSERT_TRUE(record->returned) << problem.name << " " << budget;
      const TrueValues& best = record->trace.back().true_values;
      EXPECT_FALSE(better(best, record->returned->true_values))
          << problem.name << ", budget " << budget << ": " << best.objective << " evaluated, "
          << record->returned->true_values.objective << " returned";
      ++compared;
    }
  }
  EXPECT_GT(compared, 0);
}

TEST_P(AtLimitContract, APointIsReturnedOnlyWhereOneWasEvaluated) {
  int returned = 0;
  for (const Problem& problem : problems()) {
    if (!GetParam().accepts(problem)) continue;
    for (const std::int64_t budget : {0, 1, 2, 3, 30}) {
      const RunRecord record = run(problem, GetParam(), {budget}, 0);
      EXPECT_LE(record.returned.has_value(), record.ledger.charged > 0) << problem.name;
      returned += record.returned.has_value();
    }
  }
  EXPECT_GT(returned, 0);
}

// However a search is ended, it has asked the same until then, so it returns the same.
TEST_P(AtLimitContract, APauseReturnsWhatABudgetReturns) {
  const Solver& solver = GetParam();
  for (const Problem& problem : problems()) {
    if (!solver.accepts(problem) || problem.dimension() > 3) continue;
    for (const std::int64_t budget : {1, 4, 40}) {
      std::vector<std::optional<Vector>> returned;
      for (const bool paused : {false, true}) {
        Evaluator evaluator(problem, {paused ? 1'000'000 : budget});
        if (paused) evaluator.allow(budget);
        Random random;
        returned.push_back(solver.solve(evaluator, problem.start, random).point);
      }
      EXPECT_EQ(returned[0], returned[1]) << problem.name << ", " << budget;
    }
  }
}

// The time ends at whatever call it does. The fireworks family divides what is left of the budget,
// so a run with another budget asks other points.
TEST_P(AtLimitContract, ATimeLimitReturnsWhatTheSameNumberOfEvaluationsReturns) {
  const Solver& solver = GetParam();
  for (const Problem& problem : {disc(), sphere(2, 3)}) {
    if (!solver.accepts(problem)) continue;
    const RunRecord timed = run(problem, solver, {1'000'000, 0.003}, 0);
    if (timed.termination_reason != TerminationReason::seconds || timed.trace.empty()) continue;
    ASSERT_TRUE(timed.returned) << problem.name;
    if (solver.at_limit == AtLimit::best_evaluated) {
      EXPECT_FALSE(better(timed.trace.back().true_values, timed.returned->true_values));
      continue;
    }
    // The call that time refused may cost less than the one that the budget refuses.
    const RunRecord counted = run(problem, solver, {timed.ledger.charged}, 0);
    if (counted.ledger.charged != timed.ledger.charged) continue;
    ASSERT_TRUE(counted.returned) << problem.name;
    EXPECT_EQ(counted.returned->x, timed.returned->x) << problem.name;
  }
}

std::vector<Solver> returning(AtLimit what) {
  std::vector<Solver> solvers = all_solvers();
  std::erase_if(solvers, [&](const Solver& solver) { return solver.at_limit != what; });
  return solvers;
}

std::string name_of(const testing::TestParamInfo<Solver>& tested) {
  return test_name(tested.param.name);
}

INSTANTIATE_TEST_SUITE_P(Of, AtLimitContract, testing::ValuesIn(all_solvers()), name_of);
INSTANTIATE_TEST_SUITE_P(Of, OwnAtLimitContract, testing::ValuesIn(returning(AtLimit::own_point)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Of, BestAtLimitContract,
                         testing::ValuesIn(returning(AtLimit::best_evaluated)), name_of);

}  // namespace
}  // namespace ricochet
