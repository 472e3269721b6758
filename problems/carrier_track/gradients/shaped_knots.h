#pragma once

#include "ricochet/vector.h"

namespace ricochet::carrier_track::inline gradients {

/// The speeds of knots that are a shape x scaled to a given mean:
///   speed k = scale x_k, with a scale inversely proportional to weights . x,
/// so that its derivatives are d speed k / d x_i = scale [i = k] - speed k share i.
struct ShapedKnots {
  double scale;   ///< [rad/s]
  Vector speeds;  ///< [rad/s], length n
  Vector share;   ///< weights / (weights . x), length n

  /// The gradient with respect to the shape, from that with respect to the speeds.
  Vector gradient(const Vector& by_speeds) const {
    return scale * by_speeds - speeds.dot(by_speeds) * share;
  }

  /// How the speeds change along directions of the shape, the columns of a matrix.
  Matrix along(const Matrix& directions) const {
    return scale * directions - speeds * (share.transpose() * directions);
  }

  /// How the gradient changes along these directions; `changes` has how that with respect to the
  /// speeds changes.
  Matrix change(const Vector& by_speeds, const Matrix& changes, const Matrix& directions) const {
    const Eigen::RowVectorXd shrinks = share.transpose() * directions;
    const Eigen::RowVectorXd turns =
        speeds.transpose() * changes + by_speeds.transpose() * along(directions);
    return scale * (changes - by_speeds * shrinks) -
           share * (turns - speeds.dot(by_speeds) * shrinks);
  }
};

}  // namespace ricochet::carrier_track::inline gradients
