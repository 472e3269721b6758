#include "solvers/ceres.h"

#include <ceres/first_order_function.h>
#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <ceres/version.h>

#include <cmath>
#include <limits>

#include "solvers/ceres_exit.h"
#include "solvers/unit_box.h"

namespace ricochet {
namespace {

constexpr double farthest_start = 0.999;  // |x - middle| / half width

/// The objective over y.
class Waves : public ceres::FirstOrderFunction {
 public:
  explicit Waves(Evaluator& evaluator)
      : evaluator_(evaluator),
        middle_((evaluator.problem().lower + evaluator.problem().upper) / 2),
        half_((evaluator.problem().upper - evaluator.problem().lower) / 2) {}

  int NumParameters() const override { return static_cast<int>(middle_.size()); }

  bool Evaluate(const double* parameters, double* cost, double* gradient) const override {
    const Eigen::Map<const Vector> y(parameters, middle_.size());
    const Vector x = at(y);
    if (!x.allFinite()) return false;
    if (!gradient) {
      const auto values = evaluator_.values(x, Part::objective);
      if (!values || !finite(*values)) return false;
      *cost = values->objective;
      return true;
    }
    const auto derivatives = evaluator_.derivatives(x);
    if (!derivatives || !finite(*derivatives)) return false;
    *cost = derivatives->values.objective;
    Eigen::Map<Vector>(gradient, y.size()) =
        derivatives->gradient.array() * half_.array() * y.array().cos();
    return true;
  }

  Vector at(const Vector& y) const { return middle_.array() + half_.array() * y.array().sin(); }

  Vector inverse(const Vector& x) const {
    const Vector share = (half_.array() > 0).select((x - middle_).cwiseQuotient(half_), 0.0);
    return share.cwiseMax(-farthest_start).cwiseMin(farthest_start).array().asin();
  }

 private:
  Evaluator& evaluator_;
  Vector middle_, half_;
};

SolverExit minimise(Evaluator& evaluator, const Vector& start) {
  auto* waves = new Waves(evaluator);  // `problem` owns it
  const ceres::GradientProblem problem(waves);
  Vector y = waves->inverse(start);
  ceres::GradientProblemSolver::Options options;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = std::numeric_limits<int>::max();
  options.function_tolerance = 1e-14;  // steps of 1e-8, the parameter tolerance, change f by this
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(options, problem, y.data(), &summary);
  return {evaluator.over() ? stopped_by_evaluator : in_words(summary.termination_type),
          waves->at(y)};
}

}  // namespace

Solver ceres_lbfgs() {
  silence_ceres();
  Solver solver;
  solver.name = "ceres-lbfgs";
  solver.version = "Ceres " CERES_VERSION_STRING;
  solver.accepts = [](const Problem& problem) {
    return has_room(problem) && problem.constraints == 0 && problem.differentiate;
  };
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random&) {
    return minimise(evaluator, start);
  };
  return solver;
}

}  // namespace ricochet
