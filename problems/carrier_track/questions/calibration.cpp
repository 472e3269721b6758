#include "problems/carrier_track/questions/calibration.h"

#include <fmt/format.h>

#include <cmath>

#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/questions/best_known.h"
#include "problems/carrier_track/questions/gradient_cost.h"
#include "problems/carrier_track/questions/misfit.h"

namespace ricochet::carrier_track::inline questions {
namespace {

const OpenConstant& bounds_of(Open open) {
  return open_constants()[static_cast<std::size_t>(open)];
}

/// d value / d share.
double stretch(const OpenConstant& c, double share) {
  if (c.logarithmic) return value_at(c, share) * std::log(c.upper / c.lower);
  return c.upper - c.lower;
}

}  // namespace

Freedom full_freedom(const Reading& reading) {
  return {reading, open_of(reading), natural_constants()};
}

Freedom forgotten(const Reading& reading, const std::vector<Open>& freed,
                  const Constants& constants) {
  Freedom freedom{reading, freed, constants};
  for (const Open open : freed) {
    const auto i = static_cast<std::size_t>(open);
    freedom.held[i] = natural_constants()[i];
  }
  return freedom;
}

Constants constants_at(const Freedom& freedom, const Vector& x) {
  Constants constants = freedom.held;
  for (std::size_t i = 0; i < freedom.freed.size(); ++i) {
    const Open open = freedom.freed[i];
    constants[static_cast<std::size_t>(open)] =
        value_at(bounds_of(open), x[static_cast<Eigen::Index>(i)]);
  }
  return constants;
}

Vector point_of(const Freedom& freedom, const Constants& constants) {
  Vector x(static_cast<Eigen::Index>(freedom.freed.size()));
  for (std::size_t i = 0; i < freedom.freed.size(); ++i) {
    const Open open = freedom.freed[i];
    x[static_cast<Eigen::Index>(i)] =
        share_of(bounds_of(open), constants[static_cast<std::size_t>(open)]);
  }
  return x;
}

Problem calibration_problem(const Freedom& freedom, const std::string& left_out) {
  const auto n = static_cast<Eigen::Index>(freedom.freed.size());
  Problem problem;
  problem.name = fmt::format("calibration-{}", name_of(freedom.reading));
  for (const Open open : freedom.freed) problem.name += fmt::format("-{}", bounds_of(open).name);
  for (const Open open : freedom.freed) {
    problem.variables.push_back({std::string(bounds_of(open).name), ""});
  }
  problem.source = "distance from the paper's claims, section 3.3, over the open constants";
  problem.lower = Vector::Zero(n);
  problem.upper = Vector::Ones(n);
  problem.start = point_of(freedom, freedom.held);
  problem.evaluate = [freedom, left_out](const Vector& x) {
    return Values{misfit(freedom.reading, constants_at(freedom, x), left_out), {}};
  };
  problem.residuals = [freedom](const Vector& x) {
    SmoothMisfit smooth =
        smooth_misfit(freedom.reading, constants_at(freedom, x), freedom.freed, default_width);
    for (std::size_t i = 0; i < freedom.freed.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      smooth.slopes.col(column) *= stretch(bounds_of(freedom.freed[i]), x[column]);
    }
    return Residuals{std::move(smooth.residuals), std::move(smooth.slopes)};
  };
  return problem;
}

Question calibration_question(const FittedReading& fitted) {
  const Freedom freedom = forgotten(fitted.reading, fitted.freed, fitted.constants);
  Problem problem = calibration_problem(freedom);
  problem.name = "calibration-default";
  know_best(problem, fitted.name);
  if (!problem.best_known) {
    problem.best_point = point_of(freedom, fitted.constants);
    problem.best_known = problem.evaluate(*problem.best_point).objective;
    problem.provenance = fitted.provenance;
  }
  return {
      .stated = std::move(problem), .tolerance = 0.01, .gradient_cost = calibration_gradient_cost};
}

}  // namespace ricochet::carrier_track::inline questions
