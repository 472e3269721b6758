#include "src/benchmark/experiment/perturbations/constraints.h"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "src/benchmark/experiment/perturbations/perturbed_calls.h"

namespace ricochet {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

class Binary : public PerturbedCalls {
 public:
  Values values(const Problem& shown, const Vector& x) override {
    return answered(shown.evaluate(x), shown.equalities);
  }
  Derivatives derivatives(const Problem& shown, const Vector& x) override {
    Derivatives told = shown.differentiate(x);
    told.values = answered(std::move(told.values), shown.equalities);
    told.jacobian.setZero();
    return told;
  }
  Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                 const Vector& multipliers) override {
    return shown.lagrangian_hessian(x, objective_factor, Vector::Zero(multipliers.size()));
  }

 private:
  static Values answered(Values told, Eigen::Index equalities) {
    for (Eigen::Index k = 0; k < told.constraints.size(); ++k) {
      double& constraint = told.constraints[k];
      constraint = violation_of(constraint, k < equalities) == 0 ? 0 : 1;
    }
    return told;
  }
};

class Infinite : public PerturbedCalls {
 public:
  Values values(const Problem& shown, const Vector& x) override {
    Values told = shown.evaluate(x);
    if (broken(shown, told)) told.objective = infinity;
    return told;
  }
  Derivatives derivatives(const Problem& shown, const Vector& x) override {
    Derivatives told = shown.differentiate(x);
    if (broken(shown, told.values)) {
      told.values.objective = infinity;
      told.gradient.setConstant(not_a_number);
    }
    return told;
  }
  Residuals residuals(const Problem& shown, const Vector& x) override {
    Residuals told = shown.residuals(x);
    if (broken(shown, shown.evaluate(x))) {
      told.values.setConstant(infinity);
      told.jacobian.setConstant(not_a_number);
    }
    return told;
  }
  Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                 const Vector& multipliers) override {
    Matrix told = shown.lagrangian_hessian(x, objective_factor, multipliers);
    if (objective_factor != 0 && broken(shown, shown.evaluate(x))) told.setConstant(not_a_number);
    return told;
  }

 private:
  static bool broken(const Problem& shown, const Values& told) {
    const Vector inequalities = told.constraints.tail(shown.constraints - shown.equalities);
    return true_values_of({told.objective, inequalities}).violation != 0;
  }
};

}  // namespace

Perturbation binary_constraints() {
  return {"binary-constraints",
          "a constraint is 0 where it holds and 1 elsewhere, without a magnitude",
          [](const Problem& problem) { return problem.constraints > 0; },
          [](const Problem& shown, std::uint64_t) {
            return perturbed_by(std::make_shared<Binary>(), shown);
          }};
}

Perturbation infinite_where_infeasible() {
  return {"infinite-where-infeasible", "the objective is infinite where an inequality is broken",
          [](const Problem& problem) { return problem.constraints > problem.equalities; },
          [](const Problem& shown, std::uint64_t) {
            return perturbed_by(std::make_shared<Infinite>(), shown);
          }};
}

}  // namespace ricochet
