#include "solvers/plateau_search/shape.h"

#include <cmath>

namespace ricochet::drifting {
namespace {

constexpr double greatest_scale = 1e50;

}  // namespace

Vector Shape::shaped(const Vector& z) const {
  return std::sqrt(scale_) * Vector(factor_.matrixL() * z);
}

void Shape::stretch(const Vector& p, double share) {
  scale_ *= 1 - share;
  change(p, share);
}

void Shape::shrink(const Vector& z, double share) {
  const Vector step = shaped(z);
  scale_ *= 1 + share;
  change(step, -share);
}

void Shape::flatten(const Vector& v, double share) {
  const Vector w = factor_.matrixL().solve(v) / std::sqrt(scale_);
  if (w.squaredNorm() > 0) change(v, -(2 * share - share * share) / w.squaredNorm());
}

void Shape::change(const Vector& v, double times) {
  factor_.rankUpdate(v, times / scale_);
  if (factor_.info() != Eigen::Success || !factor_.matrixLLT().allFinite()) {
    *this = Shape(v.size());
  } else if (scale_ > greatest_scale || scale_ < 1 / greatest_scale) {
    factor_.compute(scale_ * factor_.reconstructedMatrix());
    scale_ = 1;
  }
}

}  // namespace ricochet::drifting
