#pragma once

#include <Eigen/Cholesky>

#include "src/core/vector.h"

namespace ricochet::drifting {

/// The covariance C of a search's steps, kept as its Cholesky factor L, C = L L'. Begins as the
/// identity, and does so again where rounding has left it no covariance. Every change is of rank
/// one.
class Shape {
 public:
  explicit Shape(Eigen::Index n) : factor_(Matrix::Identity(n, n)) {}

  /// L z.
  Vector shaped(const Vector& z) const;

  /// C <- (1 - share) C + share p p'.
  void stretch(const Vector& p, double share);

  /// C <- (1 + share) C - share (L z)(L z)'.
  void shrink(const Vector& z, double share);

  /// Takes the share of the deviation along v away: C <- C - (1 - (1 - share)^2) v v' / |L^-1 v|^2.
  void flatten(const Vector& v, double share);

 private:
  void change(const Vector& v, double times);

  Eigen::LLT<Matrix> factor_;
  double scale_ = 1;  // C is so many times what was factored
};

}  // namespace ricochet::drifting
