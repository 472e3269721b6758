#pragma once

#include <span>

#include "ricochet/random.h"

namespace ricochet::fireworks {

/// The multivariate normal distribution from which a firework of FWASSP draws its sparks: mean,
/// scale and covariance matrix, N(mean, scale² C). It adapts as in CMA-ES (Hansen, arXiv
/// 1604.00772), and is fitted to points of the surface that it shares with its neighbours. The
/// surface is where the squared Mahalanobis distance is expected(), that of a typical spark.
class SearchDistribution {
 public:
  /// C is the unit matrix; scale > 0. `mean` has at least one coordinate.
  SearchDistribution(Vector mean, double scale);

  const Vector& mean() const { return mean_; }

  /// Largest standard deviation over all directions.
  double width() const;

  Vector draw(Random& random) const;

  /// Squared Mahalanobis distance of x from the mean.
  double distance(const Vector& x) const;

  /// Square of the approximate mean length of a standard normal vector.
  double expected() const;

  /// Euclidean distance from the mean to the surface in the direction of x, which is not the mean.
  double radius_towards(const Vector& x) const;

  /// Moves to the better half of the sparks and adapts the covariance matrix and the scale. A row
  /// of `sparks` is a point; `order` lists the rows from the best to the worst.
  void adapt(const Matrix& sparks, std::span<const Eigen::Index> order);

  /// Changes the covariance matrix so that the surface comes nearer to each point (row): for one
  /// point and rate 1 it goes through it. 0 < rate <= 1. Points at the mean are ignored.
  void fit(const Matrix& points, double rate);

 private:
  void decompose();

  Vector mean_;
  double scale_;
  Matrix covariance_, vectors_;
  Vector values_;                   // eigenvalues of C
  Vector scale_path_, shape_path_;  // p_sigma and p_c of CMA-ES
  int generation_ = 0;
};

}  // namespace ricochet::fireworks
