#include <ceres/cost_function.h>
#include <ceres/first_order_function.h>
#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <ceres/types.h>
#include <ceres/version.h>
#include <glog/logging.h>

#include <cmath>
#include <limits>
#include <string>

#include "solvers/library_solvers.h"
#include "solvers/scaled_box.h"

/// Only for the adapters of Ceres.
namespace ricochet {

/// Silences the warnings that Ceres writes to standard error where a function is flat, whatever its
/// options are. The run's record holds what the suite needs.
inline void silence_ceres() {
  FLAGS_minloglevel = google::GLOG_FATAL;
}

/// Ceres's termination type as text.
inline std::string in_words(ceres::TerminationType type) {
  switch (type) {
    case ceres::CONVERGENCE:
      return "converged";
    case ceres::NO_CONVERGENCE:
      return "iterations spent";
    default:
      return "failure";
  }
}

namespace {

constexpr double farthest_start = 0.999;  // |x - middle| / half width

/// The objective over y.
class EvaluatedObjective : public ceres::FirstOrderFunction {
 public:
  EvaluatedObjective(Evaluator& evaluator, Coordinates coordinates)
      : evaluator_(evaluator),
        middle_((evaluator.lower() + evaluator.upper()) / 2),
        half_((evaluator.upper() - evaluator.lower()) / 2),
        slope_(ScaledBox(evaluator, coordinates).scale()) {
    if (coordinates != Coordinates::own) slope_ /= 2;
  }

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
        derivatives->gradient.array() * slope_.array() * angle(y).array().cos();
    return true;
  }

  Vector at(const Vector& y) const {
    return middle_.array() + half_.array() * angle(y).array().sin();
  }

  Vector inverse(const Vector& x) const {
    const Vector share = (half_.array() > 0).select((x - middle_).cwiseQuotient(half_), 0.0);
    const Vector angle = share.cwiseMax(-farthest_start).cwiseMin(farthest_start).array().asin();
    return (slope_.array() > 0).select(angle.cwiseProduct(half_).cwiseQuotient(slope_), 0.0);
  }

 private:
  Vector angle(const Vector& y) const {
    return (half_.array() > 0).select(y.cwiseProduct(slope_).cwiseQuotient(half_), 0.0);
  }

  Evaluator& evaluator_;
  Vector middle_, half_;
  Vector slope_;  // dx / dy in the middle of the box
};

using Options = ceres::GradientProblemSolver::Options;

Options own_options() {
  Options options;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = std::numeric_limits<int>::max();
  // A refused evaluation is a failure to Ceres, which then keeps this state: that of the last
  // iteration, as after max_num_iterations.
  options.update_state_every_iteration = true;
  options.function_tolerance = 1e-14;  // the parameter tolerance, steps of 1e-8, changes f by this
  return options;
}

/// What a plan may change.
struct LineSearchOptions {
  Options ceres = own_options();
  Coordinates coordinates = Coordinates::own;
};

template <class Visit, IsOf<LineSearchOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(whole_option("max_lbfgs_rank", 1, 1000), o.ceres.max_lbfgs_rank...);
  visit(real_option("function_tolerance", 0, 1), o.ceres.function_tolerance...);
  visit(real_option("gradient_tolerance", 0, 1e9), o.ceres.gradient_tolerance...);
  visit(real_option("parameter_tolerance", 0, 1), o.ceres.parameter_tolerance...);
  Field decrease = real_option("line_search_sufficient_function_decrease", 1e-12, 0.5);
  Field curvature = real_option("line_search_sufficient_curvature_decrease", 0.5, 1);
  decrease.range.without_most = curvature.range.without_most = true;
  visit(decrease, o.ceres.line_search_sufficient_function_decrease...);
  visit(curvature, o.ceres.line_search_sufficient_curvature_decrease...);
  visit(coordinates_option, o.coordinates...);
}

SolverTermination minimise(Evaluator& evaluator, const Vector& start,
                           const LineSearchOptions& options) {
  auto* waves = new EvaluatedObjective(evaluator, options.coordinates);  // `problem` owns it
  const ceres::GradientProblem problem(waves);
  Vector y = waves->inverse(start);
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(options.ceres, problem, y.data(), &summary);
  return {evaluator.over() ? stopped_by_evaluator : in_words(summary.termination_type),
          waves->at(y)};
}

Solver lbfgs(const LineSearchOptions& options) {
  silence_ceres();
  Solver solver;
  solver.name = "ceres-lbfgs";
  solver.version = "Ceres " CERES_VERSION_STRING " (adapter 3)";
  solver.capabilities = ceres_lbfgs_capabilities;
  solver.at_limit = AtLimit::own_point;
  solver.solve = [options](Evaluator& evaluator, const Vector& start, Random&) {
    return minimise(evaluator, start, options);
  };
  return solver;
}

}  // namespace

Solver ceres_lbfgs() {
  return lbfgs({});
}

AdjustableSolver adjustable_ceres_lbfgs() {
  return adjustable("ceres-lbfgs", LineSearchOptions(), lbfgs);
}

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class ScaledResiduals : public ceres::CostFunction {
 public:
  ScaledResiduals(ScaledBox& box, Eigen::Index count, Eigen::Index dimension) : box_(box) {
    set_num_residuals(static_cast<int>(count));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(dimension));
  }

  bool Evaluate(double const* const* parameters, double* values,
                double** jacobians) const override {
    const Eigen::Map<const Vector> u(parameters[0], parameter_block_sizes().front());
    Eigen::Map<Vector> told(values, num_residuals());
    if (!jacobians || !jacobians[0]) {  // a trial step: most rejected steps end here
      const auto seen = box_.residual_values(u);
      if (!seen || !seen->allFinite() || seen->size() != num_residuals()) return false;
      told = *seen;
      return true;
    }
    const auto seen = box_.residuals(u, Part::jacobian);
    if (!seen || !finite(*seen) || seen->values.size() != num_residuals()) return false;
    told = seen->values;
    Eigen::Map<RowMajor>(jacobians[0], num_residuals(), u.size()) = seen->jacobian;
    return true;
  }

 private:
  ScaledBox& box_;
};

using LeastSquaresOptions = ceres::Solver::Options;

LeastSquaresOptions own_least_squares_options() {
  LeastSquaresOptions options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  // Between bounds Ceres looks for every step along a line. QUADRATIC needs values only; CUBIC
  // would also need slopes.
  options.line_search_interpolation_type = ceres::QUADRATIC;
  options.max_num_iterations = std::numeric_limits<int>::max();
  options.update_state_every_iteration = true;  // as ceres-lbfgs
  options.function_tolerance = 1e-14;  // the parameter tolerance, steps of 1e-8, changes f by this
  options.gradient_tolerance = 0;      // it has the unit of the residuals, which is unknown
  return options;
}

/// What a plan may change.
struct TrustRegionOptions {
  LeastSquaresOptions ceres = own_least_squares_options();
  Coordinates coordinates = Coordinates::unit;  ///< in own ones it depends on the residuals' unit
};

template <class Visit, IsOf<TrustRegionOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(real_option("initial_trust_region_radius", 1e-12, 1e16),
        o.ceres.initial_trust_region_radius...);
  visit(real_option("function_tolerance", 0, 1), o.ceres.function_tolerance...);
  visit(real_option("parameter_tolerance", 0, 1), o.ceres.parameter_tolerance...);
  visit(coordinates_option, o.coordinates...);
}

SolverTermination minimise_squares(Evaluator& evaluator, const Vector& start,
                                   const TrustRegionOptions& options) {
  ScaledBox box(evaluator, options.coordinates);
  Vector u = box.to_scaled(start);
  // Ceres needs the number of residuals beforehand; the evaluator remembers their values.
  const auto first = box.residual_values(u, Part::nothing);
  if (!first) return {stopped_by_evaluator};
  if (!first->allFinite()) return {not_finite};
  ceres::Problem problem;
  problem.AddResidualBlock(new ScaledResiduals(box, first->size(), u.size()), nullptr,
                           u.data());  // `problem` owns it
  for (int i = 0; i < static_cast<int>(u.size()); ++i) {
    problem.SetParameterLowerBound(u.data(), i, box.lower()[i]);
    problem.SetParameterUpperBound(u.data(), i, box.upper()[i]);
  }
  ceres::Solver::Summary summary;
  ceres::Solve(options.ceres, &problem, &summary);
  return {evaluator.over() ? stopped_by_evaluator : in_words(summary.termination_type),
          box.from_scaled(u)};
}

Solver least_squares(const TrustRegionOptions& options) {
  silence_ceres();
  Solver solver;
  solver.name = "ceres-trust-region";
  solver.version = "Ceres " CERES_VERSION_STRING " (adapter 3)";
  solver.capabilities = ceres_least_squares_capabilities;
  solver.at_limit = AtLimit::own_point;
  solver.solve = [options](Evaluator& evaluator, const Vector& start, Random&) {
    return minimise_squares(evaluator, start, options);
  };
  return solver;
}

}  // namespace

Solver ceres_least_squares() {
  return least_squares({});
}

AdjustableSolver adjustable_ceres_least_squares() {
  return adjustable("ceres-trust-region", TrustRegionOptions(), least_squares);
}

}  // namespace ricochet
