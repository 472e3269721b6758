#include "problems/carrier_track/identification/knock_problem.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace ricochet::carrier_track::inline identification {

Vector within_limits(const Vector& x) {
  Vector lowest(knock_unknowns), highest(knock_unknowns);
  lowest << -5, std::log(1e-4), std::log(1e-7), -100, -0.2, std::log(1e-7), -5, -20, -20, -40, -7,
      -12, -0.1, -1e-3;
  highest << 4, std::log(0.999), std::log(1.0), 100, 0.2, 0, 10, 10, 20, 40, 1, 10, 0.1, 1e-3;
  return x.cwiseMax(lowest).cwiseMin(highest);
}

KnockCoordinates knock_coordinates(const KnockLoss& loss, const Vector& centre, double blur,
                                   const std::vector<Eigen::Index>& free) {
  const Matrix information = loss.information(centre, blur).information(free, free);
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(information);
  const double least = 1e-12 * eigen.eigenvalues().maxCoeff();
  const Vector scales = eigen.eigenvalues().cwiseMax(least).cwiseSqrt().cwiseInverse();
  KnockCoordinates result{centre, Matrix::Zero(knock_unknowns, information.cols())};
  result.directions(free, Eigen::all) = eigen.eigenvectors() * scales.asDiagonal();
  return result;
}

Problem knock_problem(const KnockLoss& loss, const KnockCoordinates& coordinates, double blur,
                      double reach) {
  const Eigen::Index n = coordinates.directions.cols();
  Problem problem;
  problem.name = "knocks";
  problem.source = "-ln likelihood of recorded knocks";
  problem.lower = Vector::Constant(n, -reach);
  problem.upper = Vector::Constant(n, reach);
  problem.start = Vector::Zero(n);
  problem.evaluate = [&loss, &coordinates, blur](const Vector& z) {
    return Values{loss.at(coordinates.at(z), blur), {}};
  };
  problem.differentiate = [&loss, &coordinates, blur](const Vector& z) {
    Vector slopes;
    const double value = loss.at(coordinates.at(z), blur, &slopes);
    return Derivatives{{value, {}}, coordinates.directions.transpose() * slopes, {}, {}};
  };
  return problem;
}

namespace {

constexpr int speeds = 40;

/// The largest derivative of an impact's time by a constant of the machine.
double steepest(const std::vector<PredictedImpact>& impacts, double from, double to) {
  double most = 0;
  for (const PredictedImpact& impact : impacts) {
    if (impact.time < from || impact.time > to) continue;
    for (std::size_t i = 0; i < machine_constants; ++i) {
      most = std::max(most, std::abs(impact.time_slopes[i]));
    }
  }
  return most;
}

/// Returns true if small changes grow from turn to turn.
bool is_sensitive(const KnockDensity& density, const KnockRecord& record) {
  const double middle = (record.from + record.to) / 2;
  return steepest(density.impacts(), middle, record.to) >
         5 * steepest(density.impacts(), record.from, middle);
}

}  // namespace

Matrix covariance_of(const KnockDensity::Information& information,
                     const std::vector<Eigen::Index>& free) {
  const auto n = static_cast<Eigen::Index>(free.size());
  const Matrix inverse =
      Matrix(information.information(free, free)).ldlt().solve(Matrix::Identity(n, n));
  Matrix covariance = Matrix::Zero(knock_unknowns, knock_unknowns);
  covariance(free, free) = inverse * Matrix(information.score(free, free)) * inverse;
  return covariance;
}

std::optional<NextSpeed> next_speed(const KnockLoss& loss, const Vector& x, const Vector& target,
                                    double fastest) {
  const KnockRecord& record = loss.record();
  const auto [slow, fast] = std::ranges::minmax(record.speed, {}, &SpeedKnot<double>::omega);
  const double lowest = std::max(slow.omega, fast.omega / 20) / 3;
  const double highest = std::min(fastest, 2 * fast.omega);
  const KnockDensity::Information now = loss.information(x);
  const auto deviation = [&](const KnockDensity::Information& information) {
    const Matrix covariance = covariance_of(information, loss.free());
    return std::sqrt(target.dot(covariance.topLeftCorner(target.size(), target.size()) * target));
  };
  const double before = deviation(now);
  const double turned =
      angle_between(record.speed, record.from, record.to) * unknowns_at(x).speed_factor;
  std::optional<NextSpeed> best;
  for (int k = 0; k < speeds; ++k) {
    const double omega = lowest * std::pow(highest / lowest, k / (speeds - 1.0));
    KnockRecord step{{}, {{0, omega}}, 0, next_step_seconds};
    step.knocks = record.knocks;  // they say whether there are strengths, and of which range
    step.saturation = record.saturation;
    Vector there = x;
    there[coordinate::phase] += turned;
    const KnockDensity density(
        step, predicted_impacts(loss.scene(), step, there, loss.slowest(there)), there, 0);
    if (density.impacts().empty() || is_sensitive(density, step)) continue;
    // The angle at which the step begins depends on the speeds before.
    Matrix by = Matrix::Identity(knock_unknowns, knock_unknowns);
    by(coordinate::phase, coordinate::speed_factor) = turned;
    KnockDensity::Information both = density.information();
    both.information = now.information + by.transpose() * both.information * by;
    both.score = now.score + by.transpose() * both.score * by;
    const double after = deviation(both);
    if (!best || after < best->deviation) best = NextSpeed{omega, after, before};
  }
  return best;
}

}  // namespace ricochet::carrier_track::inline identification
