#include "solvers/fireworks/population.h"

#include <algorithm>

#include "solvers/fireworks/fitness.h"

namespace ricochet::fireworks {

Population::Population(Evaluator& evaluator, Eigen::Index room)
    : evaluator_(evaluator),
      points_(room, evaluator.dimension()),
      worths_(static_cast<std::size_t>(room)) {}

bool Population::add(const Vector& x) {
  const auto values = evaluator_.values(x);
  if (!values) return false;
  points_.row(size_) = x.transpose();
  worths_[static_cast<std::size_t>(size_)] = worth_of(*values, evaluator_.equalities());
  ++size_;
  return true;
}

void Population::keep(std::span<const Eigen::Index> chosen) {
  const auto count = static_cast<Eigen::Index>(chosen.size());
  Matrix points(count, points_.cols());
  std::vector<TrueValues> worths;
  worths.reserve(chosen.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index from = chosen[static_cast<std::size_t>(i)];
    points.row(i) = points_.row(from);
    worths.push_back(worth(from));
  }
  points_.topRows(count) = points;
  std::copy(worths.begin(), worths.end(), worths_.begin());
  size_ = count;
}

}  // namespace ricochet::fireworks
