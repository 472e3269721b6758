#include "solvers/mads/poll_directions.h"

#include <algorithm>
#include <cmath>

namespace ricochet {
namespace {

Vector rounded(const Vector& x) {
  return x.unaryExpr([](double each) { return std::round(each); });
}

/// The longest integer vector along `direction` with a norm of at most `most`, >= 1.
Vector integers_along(const Vector& direction, double most) {
  Eigen::Index largest = 0;
  const Vector along = direction / direction.cwiseAbs().maxCoeff(&largest);
  Vector best = Vector::Zero(direction.size());
  best[largest] = along[largest];  // 1 or -1
  double shorter = 0;
  double longer = most + 1;       // then even the largest coordinate alone is too long
  constexpr int bisections = 60;  // to machine precision
  for (int i = 0; i < bisections; ++i) {
    const double middle = (shorter + longer) / 2;
    const Vector q = rounded(middle * along);
    const bool fits = q.norm() <= most;
    (fits ? shorter : longer) = middle;
    if (fits && q.squaredNorm() > best.squaredNorm()) best = q;
  }
  return best;
}

}  // namespace

Matrix poll_basis(const Vector& direction, int index) {
  const Vector q = integers_along(direction, std::sqrt(std::ldexp(1.0, index)));
  const Eigen::Index n = q.size();
  return q.squaredNorm() * Matrix::Identity(n, n) - 2 * q * q.transpose();
}

std::vector<Vector> poll_directions(const Matrix& basis, const Vector& leading) {
  std::vector<Vector> directions;
  Vector sum = Vector::Zero(leading.size());
  for (const auto& column : basis.colwise()) {
    directions.emplace_back(column.dot(leading) < 0 ? Vector(-column) : Vector(column));
    sum += directions.back();
  }
  std::stable_sort(directions.begin(), directions.end(), [&](const Vector& a, const Vector& b) {
    return a.dot(leading) > b.dot(leading);
  });
  directions.emplace_back(-sum);
  return directions;
}

}  // namespace ricochet
