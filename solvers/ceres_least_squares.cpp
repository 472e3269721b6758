#include "solvers/ceres_least_squares.h"

#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <ceres/version.h>

#include <limits>

#include "solvers/ceres_exit.h"
#include "solvers/unit_box.h"

namespace ricochet {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The residuals over the unit cube.
class UnitResiduals : public ceres::CostFunction {
 public:
  UnitResiduals(UnitBox& box, Eigen::Index count, Eigen::Index dimension) : box_(box) {
    set_num_residuals(static_cast<int>(count));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(dimension));
  }

  bool Evaluate(double const* const* parameters, double* values,
                double** jacobians) const override {
    const int n = parameter_block_sizes().front();
    const bool slopes = jacobians && jacobians[0];
    const auto seen = box_.residuals(Eigen::Map<const Vector>(parameters[0], n),
                                     slopes ? Part::jacobian : Part::objective);
    if (!seen || !finite(*seen) || seen->values.size() != num_residuals()) return false;
    Eigen::Map<Vector>(values, num_residuals()) = seen->values;
    if (slopes) {
      Eigen::Map<RowMajor>(jacobians[0], num_residuals(), n) = seen->jacobian;
    }
    return true;
  }

 private:
  UnitBox& box_;
};

SolverExit minimise(Evaluator& evaluator, const Vector& start) {
  UnitBox box(evaluator);
  Vector u = box.to_unit(start).cwiseMax(0.0).cwiseMin(1.0);
  // Ceres wants to know beforehand how many there are; the evaluator remembers what they are.
  const auto first = box.residuals(u, Part::nothing);
  if (!first) return {stopped_by_evaluator};
  if (!finite(*first)) return {not_finite};
  ceres::Problem problem;
  problem.AddResidualBlock(new UnitResiduals(box, first->values.size(), u.size()), nullptr,
                           u.data());  // `problem` owns it
  for (int i = 0; i < static_cast<int>(u.size()); ++i) {
    problem.SetParameterLowerBound(u.data(), i, 0.0);
    problem.SetParameterUpperBound(u.data(), i, 1.0);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = std::numeric_limits<int>::max();
  options.function_tolerance = 1e-14;  // steps of 1e-8, the parameter tolerance, change f by this
  options.gradient_tolerance = 0;      // it has the residuals' unit, whatever that is
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return {evaluator.over() ? stopped_by_evaluator : in_words(summary.termination_type),
          box.from_unit(u)};
}

}  // namespace

Solver ceres_least_squares() {
  silence_ceres();
  Solver solver;
  solver.name = "ceres-trust-region";
  solver.version = "Ceres " CERES_VERSION_STRING;
  solver.accepts = [](const Problem& problem) {
    return has_room(problem) && problem.constraints == 0 && problem.residuals;
  };
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random&) {
    return minimise(evaluator, start);
  };
  return solver;
}

}  // namespace ricochet
