#include "src/research/long_run/border_fit.h"

#include <tbb/parallel_for.h>

#include <Eigen/SVD>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "problems/carrier_track/problems/speed_range.h"
#include "ricochet/regimes.h"
#include "src/research/calibration/best_point.h"
#include "src/research/long_run/count_fit.h"
#include "src/research/paper/calibration_problem.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::studies::long_run {

using namespace carrier_track;
using calibration::BestPoint;

namespace {

constexpr double fastest_border = 1.5 * fastest_speed;  // a border beyond counts as if here
constexpr double slowest_border = 0.01;
constexpr double confidence = 0.95;
constexpr double difference = 1e-5;  // of a share, for derivatives

using Borders = std::vector<std::optional<double>>;

Interpretation interpretation_of(const BorderInterpretation& what) {
  Interpretation interpretation = default_interpretation().interpretation;
  if (!what.contact_friction) interpretation.normal_force = NormalForce::constant;
  return interpretation;
}

Scene machine_of(const BorderInterpretation& what, const Constants& constants, const Case& c) {
  Scene scene = scene_of(c, interpretation_of(what), constants);
  scene.omega = 1;  // any
  return scene;
}

Parameterisation parameterisation_of(const BorderInterpretation& what) {
  return {interpretation_of(what), what.free, default_interpretation().constants};
}

std::optional<double> exact_border(const BorderInterpretation& what, const Scene& scene) {
  const RegimeOptions options{slowest_border, fastest_border};
  if (what.louder == Louder::some || scene.disturbance == 0) {
    const auto border = quiet_up_to(scene, what.at_most, options);
    return border == fastest_border ? std::nullopt : border;
  }
  // All turns have more just beyond where some have; only that far are regimes needed.
  const double law =
      throw_border(scene, what.at_most, Louder::all, fastest_border).value_or(fastest_border);
  const RegimeOptions near{slowest_border, std::min(fastest_border, 1.1 * law)};
  for (const RegimeOptions& range : {near, options}) {
    for (const Regime& regime : regimes_of(scene, range)) {
      if (regime.least_per_turn > what.at_most) return regime.from;
    }
  }
  return std::nullopt;
}

/// ln(border / paper) of the cases that are not left out.
Vector errors_of(const Borders& borders, const std::string& left_out) {
  const std::vector<Case> cases = cases_with_threshold();
  std::vector<double> errors;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].id == left_out) continue;
    errors.push_back(std::log(borders[i].value_or(fastest_border) / *cases[i].claim.threshold));
  }
  return Eigen::Map<const Vector>(errors.data(), std::ssize(errors));
}

std::vector<double> list_of(const Vector& errors) {
  return {errors.begin(), errors.end()};
}

/// The errors of the law and their derivatives with respect to the shares of the bounds.
Residuals residuals_at(const BorderInterpretation& what, const Parameterisation& parameterisation,
                       const Vector& x, const std::string& left_out) {
  const auto errors = [&](const Vector& at) {
    return errors_of(law_borders(what, constants_at(parameterisation, at)), left_out);
  };
  Residuals residuals{errors(x), {}};
  residuals.jacobian.resize(residuals.values.size(), x.size());
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    Vector up = x, down = x;
    up[j] = std::min(1.0, x[j] + difference);
    down[j] = std::max(0.0, x[j] - difference);
    residuals.jacobian.col(j) = (errors(up) - errors(down)) / (up[j] - down[j]);
  }
  return residuals;
}

/// Minimises half the sum of squares of the law's errors.
Problem problem_of(const BorderInterpretation& what, const Parameterisation& parameterisation,
                   const std::string& left_out) {
  Problem problem = calibration_problem(parameterisation);
  problem.name = "borders-" + what.name;
  problem.evaluate = [=](const Vector& x) {
    const Borders borders = law_borders(what, constants_at(parameterisation, x));
    return Values{errors_of(borders, left_out).squaredNorm() / 2, {}};
  };
  problem.residuals = [=](const Vector& x) {
    return residuals_at(what, parameterisation, x, left_out);
  };
  return problem;
}

/// Fits the law near a point.
BestPoint polished(Problem problem, BestPoint best, const BorderPlan& plan) {
  if (problem.dimension() > 0) {
    calibration::improve(problem, plan.least_squares, plan.polish_evaluations, best);
  }
  return best;
}

/// The least sum of squares with one parameter at a place within its bounds.
double squares_with(const BorderInterpretation& what, const Vector& best, Eigen::Index which,
                    double share, const BorderPlan& plan) {
  Parameterisation others = parameterisation_of(what);
  Vector x = best;
  x[which] = share;
  others.held = constants_at(others, x);
  others.free.erase(others.free.begin() + which);
  const Problem problem = problem_of(what, others, "");
  return 2 * polished(problem, calibration::start_of(problem), plan).loss;
}

ParameterInterval interval_of(const BorderInterpretation& what, const Vector& best,
                              Eigen::Index which, double squares, const BorderPlan& plan) {
  const Parameterisation all = parameterisation_of(what);
  const auto parameter = what.free[static_cast<std::size_t>(which)];
  const auto value_of = [&](double share) {
    Vector x = best;
    x[which] = share;
    return constants_at(all, x)[static_cast<std::size_t>(parameter)];
  };
  const double freedom = static_cast<double>(cases_with_threshold().size() - what.free.size());
  const boost::math::fisher_f distribution(1, freedom);
  const double limit = squares * (1 + quantile(distribution, confidence) / freedom);
  ParameterInterval interval{parameter, value_of(best[which]), 0, 0, false, false};
  for (const double sign : {-1.0, 1.0}) {
    double inside = best[which], outside = inside;
    bool open = true;
    for (double distance = 1.0 / 64; open; distance *= 2) {
      outside = std::clamp(best[which] + sign * distance, 0.0, 1.0);
      open = squares_with(what, best, which, outside, plan) <= limit;
      if (open) inside = outside;
      if (outside == 0 || outside == 1) break;
    }
    for (int k = 0; k < 4 && !open; ++k) {
      const double middle = (inside + outside) / 2;
      (squares_with(what, best, which, middle, plan) <= limit ? inside : outside) = middle;
    }
    (sign < 0 ? interval.lower : interval.upper) = value_of(open ? inside : outside);
    (sign < 0 ? interval.lower_open : interval.upper_open) = open;
  }
  return interval;
}

/// The singular directions of the law's derivatives, in the logarithms of the parameters.
std::vector<Direction> directions_of(const BorderInterpretation& what, const Vector& best) {
  Matrix slopes = residuals_at(what, parameterisation_of(what), best, "").jacobian;
  const Vector errors =
      errors_of(law_borders(what, constants_at(parameterisation_of(what), best)), "");
  for (Eigen::Index j = 0; j < slopes.cols(); ++j) {
    const UnknownParameter& bounds =
        unknown_parameters()[static_cast<std::size_t>(what.free[static_cast<std::size_t>(j)])];
    slopes.col(j) /= std::log(bounds.upper / bounds.lower);
  }
  const double freedom = static_cast<double>(slopes.rows() - slopes.cols());
  const double deviation = std::sqrt(errors.squaredNorm() / freedom);
  const boost::math::students_t distribution(freedom);
  const double factor = quantile(distribution, (1 + confidence) / 2);
  const Eigen::JacobiSVD<Matrix> svd(slopes, Eigen::ComputeThinU | Eigen::ComputeThinV);
  std::vector<Direction> directions;
  for (Eigen::Index j = 0; j < slopes.cols(); ++j) {
    Vector weights = svd.matrixV().col(j);
    Eigen::Index largest = 0;
    weights.cwiseAbs().maxCoeff(&largest);
    if (weights[largest] < 0) weights = -weights;
    const double value = svd.singularValues()[j];
    directions.push_back({list_of(weights), value > 0 ? factor * deviation / value
                                                      : std::numeric_limits<double>::infinity()});
  }
  return directions;
}

}  // namespace

std::vector<BorderInterpretation> border_interpretations() {
  const std::vector<Unknown> two = {Unknown::centrifugal_mass_radius, Unknown::counting_limit};
  const std::vector<Unknown> three = {Unknown::centrifugal_mass_radius, Unknown::clearance,
                                      Unknown::counting_limit};
  std::vector<Unknown> five = three;
  five.insert(five.end(), {Unknown::normal_force, Unknown::pull});
  return {{"at most 2 a turn", 2, Louder::some, two},
          {"at most 2 a turn", 2, Louder::some, three},
          {"at most 2 a turn", 2, Louder::some, five},
          {"all turns have more than 2", 2, Louder::all, two},
          {"all turns have more than 2", 2, Louder::all, three},
          {"all turns have more than 2", 2, Louder::all, five},
          {"silence", 0, Louder::some, three},
          {"at most 4 a turn", 4, Louder::some, three},
          {"at most 2, friction not of the walls' force", 2, Louder::some, three, false}};
}

Borders law_borders(const BorderInterpretation& what, const Constants& constants) {
  Borders borders;
  for (const Case& c : cases_with_threshold()) {
    borders.push_back(
        throw_border(machine_of(what, constants, c), what.at_most, what.louder, fastest_border));
  }
  return borders;
}

Borders exact_borders(const BorderInterpretation& what, const Constants& constants) {
  const std::vector<Case> cases = cases_with_threshold();
  Borders borders(cases.size());
  tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
    borders[i] = exact_border(what, machine_of(what, constants, cases[i]));
  });
  return borders;
}

BorderFit fitted(const BorderInterpretation& what, const BorderPlan& plan) {
  const Parameterisation parameterisation = parameterisation_of(what);
  Problem law = problem_of(what, parameterisation, "");
  BestPoint best = calibration::start_of(law);
  calibration::improve(law, plan.global, plan.evaluations, best);
  calibration::improve(law, plan.local, plan.evaluations / 3, best);
  best = polished(law, best, plan);
  BorderFit fit{what, {}, {}, {}, {}, {}, {}};
  fit.directions = directions_of(what, best.x);
  fit.intervals.resize(what.free.size());
  tbb::parallel_for(std::size_t{0}, what.free.size(), [&](std::size_t j) {
    fit.intervals[j] = interval_of(what, best.x, static_cast<Eigen::Index>(j), 2 * best.loss, plan);
  });

  fit.constants = constants_at(parameterisation, best.x);
  fit.law_errors = list_of(errors_of(law_borders(what, fit.constants), ""));
  fit.errors = list_of(errors_of(exact_borders(what, fit.constants), ""));

  const std::vector<Case> cases = cases_with_threshold();
  fit.left_out.resize(cases.size());
  tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
    const Problem others = problem_of(what, parameterisation, cases[i].id);
    const BestPoint there = polished(others, {best.x, others.evaluate(best.x).objective}, plan);
    const auto border =
        exact_border(what, machine_of(what, constants_at(parameterisation, there.x), cases[i]));
    fit.left_out[i] = std::log(border.value_or(fastest_border) / *cases[i].claim.threshold);
  });
  return fit;
}

}  // namespace ricochet::studies::long_run
