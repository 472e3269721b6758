#include "problems/classic/formula.h"

#include <Eigen/QR>
#include <vector>

namespace ricochet::classic {

Problem without_functions(Statement statement) {
  Problem problem;
  problem.name = std::move(statement.name);
  problem.source = std::move(statement.source);
  problem.start = statement.start.cwiseMax(statement.lower).cwiseMin(statement.upper);
  problem.lower = std::move(statement.lower);
  problem.upper = std::move(statement.upper);
  problem.best_known = statement.best_known;
  problem.best_point = std::move(statement.best_point);
  problem.provenance = std::move(statement.provenance);
  if (problem.provenance.starts_with(closed_form)) problem.lower_bound = problem.best_known;
  problem.rotates = statement.rotates;
  problem.start_scales = std::move(statement.start_scales);
  problem.cluster = std::move(statement.cluster);
  return problem;
}

namespace {

constexpr double active_within = 1e-9;  // of a constraint or of a coordinate
constexpr double rounding = 1e-10;      // relative to the gradient

/// A constraint or a bound that holds with equality at the best point.
struct Active {
  Vector gradient;
  std::optional<Eigen::Index> constraint;  ///< nothing for a bound
};

std::vector<Active> active_at_best(const Problem& problem, const Derivatives& at_best) {
  const Vector& best = *problem.best_point;
  const Eigen::Index n = problem.dimension();
  std::vector<Active> active;
  for (Eigen::Index i = 0; i < problem.constraints; ++i) {
    if (i < problem.equalities || at_best.values.constraints[i] > -active_within) {
      active.push_back({at_best.jacobian.row(i).transpose(), i});
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    if (best[i] - problem.lower[i] < active_within) active.push_back({-Vector::Unit(n, i), {}});
    if (problem.upper[i] - best[i] < active_within) active.push_back({Vector::Unit(n, i), {}});
  }
  return active;
}

Matrix columns(const std::vector<Active>& active, Eigen::Index n) {
  Matrix gradients(n, static_cast<Eigen::Index>(active.size()));
  for (Eigen::Index k = 0; k < gradients.cols(); ++k) {
    gradients.col(k) = active[static_cast<std::size_t>(k)].gradient;
  }
  return gradients;
}

}  // namespace

std::optional<Vector> multipliers_at_best(const Problem& problem) {
  const Derivatives at_best = problem.differentiate(*problem.best_point);
  const Vector& gradient = at_best.gradient;
  std::vector<Active> active = active_at_best(problem, at_best);
  while (true) {
    const Matrix gradients = columns(active, problem.dimension());
    const Vector weights =
        active.empty() ? Vector(0)
                       : Vector(gradients.completeOrthogonalDecomposition().solve(-gradient));
    // Where gradients depend on one another, those of negative multipliers can be done without, one
    // after the other.
    Eigen::Index worst = -1;
    double least = -rounding * gradient.norm();
    for (Eigen::Index k = 0; k < weights.size(); ++k) {
      const auto& constraint = active[static_cast<std::size_t>(k)].constraint;
      if ((constraint && *constraint < problem.equalities) || weights[k] >= least) continue;
      worst = k;
      least = weights[k];
    }
    if (worst >= 0) {
      active.erase(active.begin() + worst);
      continue;
    }
    if ((gradient + gradients * weights).norm() > rounding * (1 + gradient.norm())) return {};
    Vector multipliers = Vector::Zero(problem.constraints);
    for (Eigen::Index k = 0; k < weights.size(); ++k) {
      const auto& constraint = active[static_cast<std::size_t>(k)].constraint;
      if (constraint) multipliers[*constraint] = weights[k];
    }
    return multipliers;
  }
}

}  // namespace ricochet::classic
