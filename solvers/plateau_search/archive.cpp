#include "solvers/plateau_search/archive.h"

#include <algorithm>

namespace ricochet::drifting {

Archive::Archive(Eigen::Index n, std::size_t size)
    : points_(n, static_cast<Eigen::Index>(size)), truths_(size) {}

void Archive::add(const Vector& u, const Truth& truth) {
  points_.col(static_cast<Eigen::Index>(next_)) = u;
  truths_[next_] = truth;
  next_ = (next_ + 1) % truths_.size();
  count_ = std::min(count_ + 1, truths_.size());
}

const Truth& Archive::foretold(const Vector& u) const {
  Eigen::Index nearest = 0;
  const auto held = points_.leftCols(static_cast<Eigen::Index>(count_));
  (held.colwise() - u).colwise().squaredNorm().minCoeff(&nearest);
  return truths_[static_cast<std::size_t>(nearest)];
}

}  // namespace ricochet::drifting
