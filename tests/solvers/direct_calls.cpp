#include "tests/solvers/direct_calls.h"

#include <ceres/ceres.h>
#include <dlfcn.h>
#include <dlib/global_optimization/global_function_search.h>
#include <nlopt.h>

#include "ricochet/run.h"
#include "solvers/adjustable_solver.h"
#include "solvers/library_solvers.h"
#include "solvers/nlopt.h"
#include "tests/solvers/direct_tao.h"
#include "tests/support/problems.h"

namespace ricochet {

namespace {

// NLopt

struct ForNlopt {
  /// Once NLopt is at its limit, known points are free: AUGLAG then looks again at the best one.
  Derivatives at(const double* point, bool slopes, Part part) {
    const Vector x = call.at(point);
    const bool known = !known_points.insert({x.begin(), x.end()}).second;
    if (known && objectives > call.limit && !slopes) return {call.problem.evaluate(x), {}, {}};
    if (!slopes) return {*call.evaluator.values(x, part), {}, {}};
    Derivatives seen = *call.evaluator.derivatives(x, part);
    seen.gradient = seen.gradient.cwiseProduct(call.scale());
    seen.jacobian *= call.scale().asDiagonal();
    return seen;
  }

  const DirectCall& call;
  int objectives = 0;
  std::set<std::vector<double>> known_points = {};
};

/// Some of the constraints, to be given to NLopt.
struct Rows {
  ForNlopt* shown;
  Eigen::Index first, count;
  Part part;
};

double objective(unsigned n, const double* u, double* gradient, void* data) {
  auto& shown = *static_cast<ForNlopt*>(data);
  ++shown.objectives;
  const Derivatives seen = shown.at(u, gradient, Part::objective);
  if (gradient) Eigen::Map<Vector>(gradient, n) = seen.gradient;
  return seen.values.objective;
}

void constraints(unsigned, double* result, unsigned n, const double* u, double* jacobian,
                 void* data) {
  const Rows& rows = *static_cast<Rows*>(data);
  const Derivatives seen = rows.shown->at(u, jacobian, rows.part);
  Eigen::Map<Vector>(result, rows.count) = seen.values.constraints.segment(rows.first, rows.count);
  if (jacobian) {
    Eigen::Map<RowMajor>(jacobian, rows.count, n) =
        seen.jacobian.middleRows(rows.first, rows.count);
  }
}

double largest(unsigned, const double* u, double*, void* data) {
  const Rows& rows = *static_cast<Rows*>(data);
  return rows.shown->at(u, false, rows.part).values.constraints.maxCoeff();
}

Vector call_nlopt(const NloptAlgorithm& algorithm, const DirectCall& call) {
  const Problem& problem = call.problem;
  const auto n = static_cast<unsigned>(problem.dimension());
  ForNlopt shown{call};
  Rows equal{&shown, 0, problem.equalities, Part::equalities};
  Rows other{&shown, problem.equalities, problem.constraints - problem.equalities,
             Part::inequalities};
  const Vector lower = call.u(problem.lower), upper = call.u(problem.upper);
  const auto made = [&](nlopt_algorithm id) {
    nlopt_opt created = nlopt_create(id, n);
    nlopt_set_xtol_abs(created, Vector(algorithm.tolerance * (upper - lower)).data());
    if (!call.library_chooses) {
      nlopt_set_vector_storage(created, static_cast<unsigned>(algorithm.vectors));
    }
    return created;
  };
  nlopt_opt search = made(algorithm.id);
  nlopt_set_lower_bounds(search, lower.data());
  nlopt_set_upper_bounds(search, upper.data());
  nlopt_set_min_objective(search, objective, &shown);
  const Vector tolerances = Vector::Constant(problem.constraints, constraint_tolerance);
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
  if (!call.library_chooses) {
    nlopt_set_initial_step(search, Vector(algorithm.initial_step * (upper - lower)).data());
  }
  if (algorithm.local) {
    nlopt_opt local = made(*algorithm.local);
    nlopt_set_local_optimizer(search, local);
    nlopt_destroy(local);
  }
  nlopt_set_maxeval(search, call.limit);
  nlopt_srand(call.seed);
  Vector u = call.u(problem.start).cwiseMax(lower).cwiseMin(upper);
  double lowest = 0;
  nlopt_optimize(search, u.data(), &lowest);
  nlopt_destroy(search);
  return call.x(u);
}

// Ceres

/// The objective over y, with x = middle + half sin(y / half), as Ceres takes no bounds: dx / dy in
/// the middle is 1. A caller who knows that the bounds do not matter leaves them out: x = y.
class Waves : public ceres::FirstOrderFunction {
 public:
  explicit Waves(const DirectCall& call)
      : call_(call), half_(call.width() / 2), middle_(call.problem.lower + half_) {}
  int NumParameters() const override { return static_cast<int>(half_.size()); }
  bool Evaluate(const double* parameters, double* cost, double* gradient) const override {
    const Vector y = Eigen::Map<const Vector>(parameters, half_.size());
    if (!gradient) {
      *cost = call_.evaluator.values(x(y), Part::objective)->objective;
      return true;
    }
    const Derivatives seen = *call_.evaluator.derivatives(x(y));
    *cost = seen.values.objective;
    Eigen::Map<Vector> slope(gradient, y.size());
    slope = seen.gradient;
    if (!call_.library_chooses) slope.array() *= (y.array() / half_.array()).cos();
    return true;
  }
  Vector x(const Vector& y) const {
    if (call_.library_chooses) return y;
    return middle_.array() + half_.array() * (y.array() / half_.array()).sin();
  }
  Vector y(const Vector& x) const {
    if (call_.library_chooses) return x;
    const Vector share = (x - middle_).cwiseQuotient(half_);
    return half_.array() * share.cwiseMax(-0.999).cwiseMin(0.999).array().asin();
  }

 private:
  const DirectCall& call_;
  Vector half_, middle_;
};

Vector call_ceres(const DirectCall& call) {
  auto* waves = new Waves(call);
  const ceres::GradientProblem posed(waves);
  Vector y = waves->y(call.problem.start);
  ceres::GradientProblemSolver::Options options;
  options.logging_type = ceres::SILENT;
  options.function_tolerance = 1e-14;
  options.max_num_iterations = call.limit - 1;
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(options, posed, y.data(), &summary);
  return waves->x(y);
}

class ForCeres : public ceres::CostFunction {
 public:
  explicit ForCeres(const DirectCall& call) : call_(call) {
    const Problem& problem = call.problem;
    set_num_residuals(static_cast<int>(problem.residuals(problem.start).values.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.dimension()));
  }
  bool Evaluate(double const* const* u, double* values, double** jacobians) const override {
    const Vector x = call_.at(u[0]);
    Eigen::Map<Vector> told(values, num_residuals());
    if (!jacobians || !jacobians[0]) {
      told = *call_.evaluator.residual_values(x);
    } else {
      const Residuals seen = *call_.evaluator.residuals(x, Part::jacobian);
      told = seen.values;
      Eigen::Map<RowMajor>(jacobians[0], num_residuals(), x.size()) =
          seen.jacobian * call_.scale().asDiagonal();
    }
    return true;
  }

 private:
  const DirectCall& call_;
};

Vector call_ceres_least_squares(const DirectCall& call) {
  const Vector lower = call.u(call.problem.lower), upper = call.u(call.problem.upper);
  Vector u = call.u(call.problem.start).cwiseMax(lower).cwiseMin(upper);
  ceres::Problem posed;
  posed.AddResidualBlock(new ForCeres(call), nullptr, u.data());
  for (int i = 0; i < static_cast<int>(u.size()); ++i) {
    posed.SetParameterLowerBound(u.data(), i, lower[i]);
    posed.SetParameterUpperBound(u.data(), i, upper[i]);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.line_search_interpolation_type = ceres::QUADRATIC;
  options.function_tolerance = 1e-14;
  options.gradient_tolerance = 0;
  options.max_num_iterations = call.limit - 1;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &posed, &summary);
  return call.x(u);
}

Vector call_dlib(const DirectCall& call) {
  using Column = dlib::matrix<double, 0, 1>;
  const auto column = [](const Vector& from) {
    Column to(from.size());
    std::copy(from.begin(), from.end(), to.begin());
    return to;
  };
  const auto value = [&](const Column& u) {
    return -call.evaluator.values(call.at(u.begin()))->objective;
  };
  const Column start = column(call.problem.start);
  const dlib::function_spec box(column(call.problem.lower), column(call.problem.upper));
  dlib::global_function_search search({box}, {{{start, value(start)}}});
  search.set_seed(static_cast<std::time_t>(call.seed));
  for (int k = 1; k < call.limit; ++k) {
    dlib::function_evaluation_request request = search.get_next_x();
    request.set(value(request.x()));
  }
  Column best;
  double highest = 0;
  std::size_t of = 0;
  search.get_best_function_eval(best, highest, of);
  return call.at(best.begin());
}

#ifdef RICOCHET_HAS_TAO
double tell(const DirectTao& asked, const double* u, double* told, double* jacobian) {
  const DirectCall& call = *static_cast<const DirectCall*>(asked.data);
  const Vector x = call.at(u);
  Derivatives seen;
  if (jacobian) {
    Eigen::Map<Matrix>(jacobian, asked.m, asked.n) =
        call.evaluator.residuals(x, Part::jacobian)->jacobian;
  } else if (asked.m > 0) {
    Eigen::Map<Vector>(told, asked.m) = *call.evaluator.residual_values(x);
  } else if (told) {
    seen = *call.evaluator.derivatives(x);
    Eigen::Map<Vector>(told, asked.n) = seen.gradient;
  } else {
    seen.values = *call.evaluator.values(x);
  }
  return seen.values.objective;
}

using CallOfTao = void (*)(const DirectTao*, const char*, double*);

CallOfTao loaded_tao() {
  for (const Solver& solver : tao_solvers()) run(sphere(2, 3), solver, {5}, 0);  // starts PETSc
  void* library = dlopen(RICOCHET_DIRECT_TAO, RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
  void* call = library ? dlsym(library, "direct_tao") : nullptr;
  if (!call) throw std::runtime_error(dlerror());
  return reinterpret_cast<CallOfTao>(call);
}

Vector call_tao(const std::string& solver, const DirectCall& call) {
  static const CallOfTao directly = loaded_tao();
  const bool of_residuals = solver == "tao-pounders" || solver == "tao-brgn";
  const Problem& problem = call.problem;
  const auto n = static_cast<int>(problem.dimension());
  const int m = of_residuals ? static_cast<int>(problem.residuals(problem.start).values.size()) : 0;
  const DirectTao asked{n, m, call.limit, problem.lower.data(), problem.upper.data(), tell, &call};
  Vector x = problem.start;
  directly(&asked, solver.substr(4).c_str(), x.data());
  return x;
}
#endif

}  // namespace

std::function<Vector(const DirectCall&)> direct_call(const std::string& solver) {
  using Call = Vector (*)(const std::string&, const DirectCall&);
  const auto named = [&](Call call) {
    return [=](const DirectCall& asked) { return call(solver, asked); };
  };
  for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
    if (solver != std::string("nlopt-") + algorithm.name) continue;
    return [algorithm](const DirectCall& call) { return call_nlopt(algorithm, call); };
  }
  if (solver == "ceres-lbfgs") return call_ceres;
  if (solver == "ceres-trust-region") return call_ceres_least_squares;
  if (solver == "dlib-global-search") return call_dlib;
  if (solver.starts_with("ipopt")) return named(call_ipopt);
  if (solver.starts_with("pagmo-")) return named(call_pagmo);
#ifdef RICOCHET_HAS_TAO
  if (solver.starts_with("tao-")) return named(call_tao);
#endif
  return nullptr;
}

Coordinates coordinates_of(const std::string& solver) {
  Coordinates usual = Coordinates::unit;
  for (const AdjustableSolver& adjustable : adjustable_solvers()) {
    if (adjustable.name != solver) continue;
    for (const SolverOption& option : adjustable.options) {
      if (option.name == coordinates_option.key) give(OptionValue(option.usual), usual);
    }
  }
  return usual;
}

}  // namespace ricochet
