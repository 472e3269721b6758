#include "src/studies/paper/theory.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <utility>

namespace ricochet::carrier_track::inline paper {

namespace {

using Points = std::vector<ThresholdPoint>;

double log_loss(const ThresholdPoint& point) {
  return std::log((1 - point.restitution) / (1 + point.restitution));
}

double one(const ThresholdPoint& /*point*/) {
  return 1;
}

double friction(const ThresholdPoint& point) {
  return point.friction;
}

double disturbance(const ThresholdPoint& point) {
  return point.disturbance;
}

/// The best constants; nothing if the points do not determine them.
std::optional<std::vector<double>> solved(const Formula& formula, const Points& points) {
  const auto rows = static_cast<Eigen::Index>(points.size());
  const auto columns = static_cast<Eigen::Index>(formula.factors.size());
  Eigen::MatrixXd matrix(rows, columns);
  Eigen::VectorXd right(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const ThresholdPoint& point = points[static_cast<std::size_t>(i)];
    right[i] = std::log(point.threshold) - formula.power * log_loss(point);
    for (Eigen::Index j = 0; j < columns; ++j) {
      matrix(i, j) = formula.factors[static_cast<std::size_t>(j)](point);
    }
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
  if (qr.rank() < columns) return std::nullopt;
  const Eigen::VectorXd solution = qr.solve(right);
  std::vector<double> constants(solution.begin(), solution.end());
  constants[0] = std::exp(constants[0]);
  return constants;
}

double threshold_by(const Formula& formula, const std::vector<double>& constants,
                    const ThresholdPoint& point) {
  double logarithm = formula.power * log_loss(point) + std::log(constants[0]);
  for (std::size_t j = 1; j < constants.size(); ++j)
    logarithm += constants[j] * formula.factors[j](point);
  return std::exp(logarithm);
}

std::optional<double> left_out_error(const Formula& formula, const Points& points) {
  double squares = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Points others = points;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const auto constants = solved(formula, others);
    if (!constants) return std::nullopt;
    const double predicted = threshold_by(formula, *constants, points[i]);
    squares += std::pow(std::log(predicted / points[i].threshold), 2);
  }
  return std::sqrt(squares / static_cast<double>(points.size()));
}

}  // namespace

PredictionErrors errors_of(const Points& points, const std::vector<double>& predicted) {
  const auto size = static_cast<double>(points.size());
  double mean = 0;
  for (const ThresholdPoint& point : points) mean += std::log(point.threshold) / size;
  PredictionErrors errors{};
  double squares = 0;
  double variation = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double error = std::log(predicted[i] / points[i].threshold);
    squares += error * error;
    variation += std::pow(std::log(points[i].threshold) - mean, 2);
  }
  errors.rms = std::sqrt(squares / size);
  if (variation > 0) errors.explained = 1 - squares / variation;
  return errors;
}

Formula square_root_formula() {
  return {"w = c √R", {"c"}, 0.5, {one}};
}

Formula friction_formula() {
  return {"w = c √R exp(k μ)", {"c", "k"}, 0.5, {one, friction}};
}

std::vector<Formula> all_formulas() {
  return {
      {"w = c", {"c"}, 0, {one}},
      square_root_formula(),
      {"w = c Rᵖ", {"c", "p"}, 0, {one, log_loss}},
      friction_formula(),
      {"w = c √R exp(k μ + d D)", {"c", "k", "d"}, 0.5, {one, friction, disturbance}},
      {"w = c Rᵖ exp(k μ + d D)", {"c", "p", "k", "d"}, 0, {one, log_loss, friction, disturbance}}};
}

std::optional<FormulaFit> fitted(const Formula& formula, const Points& points) {
  if (points.size() <= formula.constants.size()) return std::nullopt;
  const auto constants = solved(formula, points);
  if (!constants) return std::nullopt;
  std::vector<double> predicted;
  for (const ThresholdPoint& point : points)
    predicted.push_back(threshold_by(formula, *constants, point));
  return FormulaFit{*constants, errors_of(points, predicted), left_out_error(formula, points)};
}

TheoreticalMotion on_arc(double radius, double omega) {
  return {radius * omega, radius * omega * omega};
}

TheoreticalMotion on_crossing(double radius, double omega, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {radius * omega / (c * c),
          radius * omega * omega / (c * c * c) * std::sqrt(c * c * c * c + 4 * s * s * s * s)};
}

std::vector<SpeedKnot<double>> crossing_profile(double omega, double angle, double turns) {
  std::vector<SpeedKnot<double>> knots;
  for (int half = 0; half < std::ceil(2 * turns); ++half) {
    const double middle = std::numbers::pi * (half + 0.5);
    // The leading plate has turned by `driven` from the tangent, or has as far to go.
    for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      const double driven = angle * (1 - std::abs(share));
      knots.push_back({(middle + share * angle) / omega, on_crossing(1.0, omega, driven).speed});
    }
  }
  return knots;
}

}  // namespace ricochet::carrier_track::inline paper
