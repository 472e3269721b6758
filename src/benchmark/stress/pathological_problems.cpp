#include "src/benchmark/stress/pathological_problems.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <thread>
#include <utility>

namespace ricochet::studies::stress {
namespace {

constexpr double centre = 0.3;

/// Half the sum of (x_i - 0.3)^2 on [0, 1]^n, with start 0.9 and best value 0 at 0.3, inside the
/// box. `before` is called at every evaluation; its result is added to the objective, the entries
/// of the gradient and the residuals.
Problem bowl(std::string name, Eigen::Index n, std::function<double(const Vector&)> before) {
  Problem problem;
  problem.name = std::move(name);
  problem.source = "the suite's own, to see what solvers do";
  problem.lower = Vector::Zero(n);
  problem.upper = Vector::Ones(n);
  problem.start = Vector::Constant(n, 0.9);
  problem.evaluate = [before](const Vector& x) {
    return Values{before(x) + (x.array() - centre).square().sum() / 2, {}};
  };
  problem.differentiate = [evaluate = problem.evaluate, before](const Vector& x) {
    const double more = before(x);
    Values values = evaluate(x);
    return Derivatives{std::move(values), x.array() - centre + more, Matrix(0, x.size())};
  };
  problem.residuals = [before](const Vector& x) {
    return Residuals{x.array() - centre + before(x), Matrix::Identity(x.size(), x.size())};
  };
  problem.best_known = 0;
  problem.best_point = Vector::Constant(n, centre);
  return problem;
}

double nothing(const Vector&) {
  return 0;
}

/// NaN where the sum is above 1.2, including at the start.
double no_number(const Vector& x) {
  return x.sum() > 1.2 ? std::numeric_limits<double>::quiet_NaN() : 0;
}

double infinite(const Vector& x) {
  return x.sum() > 1.2 ? std::numeric_limits<double>::infinity() : 0;
}

double throws(const Vector& x) {
  if (x.sum() < 0.8) throw std::runtime_error("the model broke");
  return 0;
}

double sleeps(const Vector&) {
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  return 0;
}

Problem plateau() {
  Problem problem = bowl("plateau", 2, nothing);
  problem.evaluate = [](const Vector&) { return Values{7, {}}; };
  problem.differentiate = [](const Vector& x) {
    return Derivatives{{7, {}}, Vector::Zero(x.size()), Matrix(0, x.size())};
  };
  problem.residuals = [](const Vector& x) {
    return Residuals{Vector::Constant(1, std::sqrt(14.0)), Matrix::Zero(1, x.size())};
  };
  problem.best_known.reset();
  problem.best_point.reset();
  return problem;
}

/// Lowest at a discontinuity, beyond which the objective is higher by 1.
Problem cliff() {
  Problem problem = bowl("cliff", 2, nothing);
  const auto value = [](const Vector& x) {
    return x[0] < centre ? 1 + x[1] : x[0] - centre + x[1];
  };
  problem.evaluate = [value](const Vector& x) { return Values{value(x), {}}; };
  problem.differentiate = [value](const Vector& x) {
    return Derivatives{{value(x), {}}, Vector{{x[0] < centre ? 0.0 : 1.0, 1.0}}, Matrix(0, 2)};
  };
  problem.residuals = nullptr;
  problem.best_point = Vector{{centre, 0}};
  return problem;
}

/// Its constraint, 1 + x^2 <= 0, holds nowhere.
Problem infeasible() {
  Problem problem = bowl("infeasible", 2, nothing);
  problem.constraints = 1;
  const auto constraint = [](const Vector& x) {
    return Vector::Constant(1, 1 + x.squaredNorm()).eval();
  };
  problem.evaluate = [evaluate = problem.evaluate, constraint](const Vector& x) {
    return Values{evaluate(x).objective, constraint(x)};
  };
  problem.differentiate = [differentiate = problem.differentiate, constraint](const Vector& x) {
    Derivatives derivatives = differentiate(x);
    derivatives.values.constraints = constraint(x);
    derivatives.jacobian = 2 * x.transpose();
    return derivatives;
  };
  problem.residuals = nullptr;
  problem.best_known.reset();
  problem.best_point.reset();
  return problem;
}

/// The first `fixed` coordinates can only be 0.3.
Problem narrow(std::string name, Eigen::Index fixed) {
  Problem problem = bowl(std::move(name), 2, nothing);
  problem.lower.head(fixed).setConstant(centre);
  problem.upper.head(fixed).setConstant(centre);
  problem.start.head(fixed).setConstant(centre);
  return problem;
}

}  // namespace

std::vector<PathologicalProblem> pathological_problems() {
  return {
      {"no number in a corner", bowl("no-number", 2, no_number)},
      {"infinite in a corner", bowl("infinite", 2, infinite)},
      {"throws near the best point", bowl("throws", 2, throws)},
      {"the same everywhere", plateau()},
      {"a cliff at the best point", cliff()},
      {"no feasible point", infeasible()},
      {"a box of one point", narrow("one-point", 2)},
      {"one coordinate without a choice", narrow("one-choice", 1)},
      {"budget 0", bowl("budget-0", 2, nothing), {0}},
      {"budget 1", bowl("budget-1", 2, nothing), {1}},
      {"an objective that sleeps, killed after 0.5 s",
       bowl("sleeps", 2, sleeps),
       {400},
       {0.5, 500}},
  };
}

}  // namespace ricochet::studies::stress
