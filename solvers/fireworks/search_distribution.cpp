#include "solvers/fireworks/search_distribution.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ricochet::fireworks {
namespace {

/// Eigenvalues of C are at least this, and C is mixed with as much of the unit matrix.
constexpr double least_value = 1e-8;
/// C is mixed with this much of its mean eigenvalue.
constexpr double shrinkage = 1e-4;

/// Weights of the better half, which add up to 1.
Vector weights_of(Eigen::Index sparks) {
  const Eigen::Index chosen = (sparks + 1) / 2;
  Vector weights(chosen);
  for (Eigen::Index i = 0; i < chosen; ++i) {
    weights[i] = std::log(static_cast<double>(chosen) + 0.5) - std::log(static_cast<double>(i + 1));
  }
  return weights / weights.sum();
}

}  // namespace

SearchDistribution::SearchDistribution(Vector mean, double scale)
    : mean_(std::move(mean)),
      scale_(scale),
      covariance_(Matrix::Identity(mean_.size(), mean_.size())),
      vectors_(covariance_),
      values_(Vector::Ones(mean_.size())),
      scale_path_(Vector::Zero(mean_.size())),
      shape_path_(Vector::Zero(mean_.size())) {}

double SearchDistribution::width() const {
  return scale_ * std::sqrt(values_.maxCoeff());
}

Vector SearchDistribution::draw(Random& random) const {
  const Vector standard = normal(mean_.size(), random);
  return mean_ + scale_ * (vectors_ * values_.cwiseSqrt().cwiseProduct(standard));
}

double SearchDistribution::distance(const Vector& x) const {
  const Vector along = vectors_.transpose() * (x - mean_) / scale_;
  return along.cwiseAbs2().cwiseQuotient(values_).sum();
}

double SearchDistribution::expected() const {
  const auto n = static_cast<double>(mean_.size());
  const double correction = 1 - 1 / (4 * n) + 1 / (21 * n * n);
  return n * correction * correction;
}

double SearchDistribution::radius_towards(const Vector& x) const {
  return (x - mean_).norm() * std::sqrt(expected() / distance(x));
}

void SearchDistribution::adapt(const Matrix& sparks, std::span<const Eigen::Index> order) {
  const auto n = static_cast<double>(mean_.size());
  const Vector weights = weights_of(sparks.rows());
  const double effective = 1 / weights.squaredNorm();
  const double path_rate = (4 + effective / n) / (n + 4 + 2 * effective / n);
  const double scale_rate = (effective + 2) / (n + effective + 5);
  const double rank_one = 2 / ((n + 1.3) * (n + 1.3) + effective);
  const double rank_many =
      std::min(1 - rank_one, 2 * (effective - 2 + 1 / effective) / ((n + 2) * (n + 2) + effective));

  const Eigen::Index chosen = weights.size();
  Matrix steps(mean_.size(), chosen);
  for (Eigen::Index i = 0; i < chosen; ++i) {
    steps.col(i) = sparks.row(order[static_cast<std::size_t>(i)]).transpose() - mean_;
  }
  const Vector moved = steps * weights;

  const double settled = 1 - std::pow(1 - scale_rate, 2 * generation_ + 1);
  const bool steady = scale_path_.squaredNorm() / n / settled < 2 + 4 / (n + 1);
  const auto path_gain = [&](double rate) {
    return std::sqrt(rate * (2 - rate) * effective) / scale_;
  };
  const Vector whitened =
      vectors_ * values_.cwiseSqrt().cwiseInverse().cwiseProduct(vectors_.transpose() * moved);
  scale_path_ = (1 - scale_rate) * scale_path_ + path_gain(scale_rate) * whitened;
  shape_path_ *= 1 - path_rate;
  if (steady) shape_path_ += path_gain(path_rate) * moved;

  const double kept = steady ? rank_one : rank_one * (1 - path_rate * (2 - path_rate));
  covariance_ *= 1 - least_value - kept - rank_many;
  covariance_ += rank_one * shape_path_ * shape_path_.transpose();
  covariance_ += rank_many / (scale_ * scale_) * steps * weights.asDiagonal() * steps.transpose();

  const double damping = 2 * effective / static_cast<double>(sparks.rows()) + 0.3 + scale_rate;
  const double growth = scale_rate / damping * (scale_path_.squaredNorm() / n - 1) / 2;
  scale_ *= std::exp(0.5 * std::min(1.0, growth));
  mean_ += moved;
  decompose();

  // The scale becomes the better half's mean distance; scale² C stays as it is.
  values_ = (1 - shrinkage) * values_.array() + shrinkage * values_.mean();
  const double spread = (steps.colwise() - moved).colwise().norm().mean();
  if (spread > 0) {
    values_ *= scale_ * scale_ / (spread * spread);
    scale_ = spread;
  }
  values_ = values_.cwiseMax(least_value);
  covariance_ = vectors_ * values_.asDiagonal() * vectors_.transpose();
  ++generation_;
}

void SearchDistribution::fit(const Matrix& points, double rate) {
  Matrix change = Matrix::Zero(mean_.size(), mean_.size());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vector point = points.row(i).transpose();
    const double there = distance(point);
    if (!(there > 0)) continue;
    const Vector step = (point - mean_) / scale_;
    change += (1 / expected() - 1 / there) * step * step.transpose();
  }
  covariance_ =
      (1 - least_value) * covariance_ + rate / static_cast<double>(points.rows()) * change;
  decompose();
  covariance_ = vectors_ * values_.asDiagonal() * vectors_.transpose();
}

void SearchDistribution::decompose() {
  covariance_.diagonal().array() += least_value;
  const Eigen::SelfAdjointEigenSolver<Matrix> solver((covariance_ + covariance_.transpose()) / 2);
  vectors_ = solver.eigenvectors();
  values_ = solver.eigenvalues().cwiseMax(least_value);
}

}  // namespace ricochet::fireworks
