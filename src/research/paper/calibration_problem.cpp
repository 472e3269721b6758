#include "src/research/paper/calibration_problem.h"

#include <fmt/format.h>

#include <cmath>

#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/problems/best_known.h"
#include "problems/carrier_track/problems/default_machine.h"
#include "problems/carrier_track/problems/gradient_cost.h"
#include "src/research/paper/loss.h"

namespace ricochet::carrier_track::inline paper {
namespace {

const UnknownParameter& bounds_of(Unknown open) {
  return unknown_parameters()[static_cast<std::size_t>(open)];
}

/// d value / d share.
double stretch(const UnknownParameter& c, double share) {
  if (c.logarithmic) return value_at(c, share) * std::log(c.upper / c.lower);
  return c.upper - c.lower;
}

}  // namespace

Parameterisation full_parameterisation(const Interpretation& interpretation) {
  return {interpretation, unknowns_of(interpretation), natural_constants()};
}

Parameterisation forgotten(const Interpretation& interpretation, const std::vector<Unknown>& free,
                           const Constants& constants) {
  Parameterisation parameterisation{interpretation, free, constants};
  for (const Unknown open : free) {
    const auto i = static_cast<std::size_t>(open);
    parameterisation.held[i] = natural_constants()[i];
  }
  return parameterisation;
}

Constants constants_at(const Parameterisation& parameterisation, const Vector& x) {
  Constants constants = parameterisation.held;
  for (std::size_t i = 0; i < parameterisation.free.size(); ++i) {
    const Unknown open = parameterisation.free[i];
    constants[static_cast<std::size_t>(open)] =
        value_at(bounds_of(open), x[static_cast<Eigen::Index>(i)]);
  }
  return constants;
}

Vector point_of(const Parameterisation& parameterisation, const Constants& constants) {
  Vector x(static_cast<Eigen::Index>(parameterisation.free.size()));
  for (std::size_t i = 0; i < parameterisation.free.size(); ++i) {
    const Unknown open = parameterisation.free[i];
    x[static_cast<Eigen::Index>(i)] =
        share_of(bounds_of(open), constants[static_cast<std::size_t>(open)]);
  }
  return x;
}

Problem calibration_problem(const Parameterisation& parameterisation, const std::string& left_out) {
  const auto n = static_cast<Eigen::Index>(parameterisation.free.size());
  Problem problem;
  problem.name = fmt::format("calibration-{}", name_of(parameterisation.interpretation));
  for (const Unknown open : parameterisation.free)
    problem.name += fmt::format("-{}", bounds_of(open).name);
  for (const Unknown open : parameterisation.free) {
    problem.variables.push_back({std::string(bounds_of(open).name), ""});
  }
  problem.source = "distance from the paper's claims, section 3.3, over the unknown parameters";
  problem.lower = Vector::Zero(n);
  problem.upper = Vector::Ones(n);
  problem.start = point_of(parameterisation, parameterisation.held);
  problem.evaluate = [parameterisation, left_out](const Vector& x) {
    return Values{
        loss(parameterisation.interpretation, constants_at(parameterisation, x), left_out), {}};
  };
  problem.residuals = [parameterisation](const Vector& x) {
    SmoothLoss smooth =
        smooth_loss(parameterisation.interpretation, constants_at(parameterisation, x),
                    parameterisation.free, default_smoothing);
    for (std::size_t i = 0; i < parameterisation.free.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      smooth.slopes.col(column) *= stretch(bounds_of(parameterisation.free[i]), x[column]);
    }
    return Residuals{std::move(smooth.residuals), std::move(smooth.slopes)};
  };
  return problem;
}

Problem calibration_problem(const FittedInterpretation& fitted) {
  const Parameterisation parameterisation =
      forgotten(fitted.interpretation, fitted.free, fitted.constants);
  Problem problem = calibration_problem(parameterisation);
  problem.name = "calibration-default";
  if (fitted.name == default_interpretation().name) know_best(problem, default_machine_hash());
  if (!problem.best_known) {
    problem.best_point = point_of(parameterisation, fitted.constants);
    problem.best_known = problem.evaluate(*problem.best_point).objective;
    problem.provenance = fitted.provenance;
  }
  problem.tolerance = 0.01;
  problem.gradient_cost = calibration_gradient_cost;
  return problem;
}

Family calibration_family() {
  return {"calibration", {calibration_problem(default_interpretation())}};
}

}  // namespace ricochet::carrier_track::inline paper
