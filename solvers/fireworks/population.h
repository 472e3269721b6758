#pragma once

#include <span>
#include <vector>

#include "ricochet/evaluator.h"

namespace ricochet::fireworks {

/// Fireworks and sparks of one generation with their values as shown to the solver, in the order of
/// evaluation. The capacity is fixed.
class Population {
 public:
  Population(Evaluator& evaluator, Eigen::Index room);

  /// Evaluates a point of the box and adds it. Returns false, and adds nothing, once the evaluator
  /// refuses. There must be room.
  bool add(const Vector& x);

  Eigen::Index size() const { return size_; }

  /// One row for each point.
  auto points() const { return points_.topRows(size_); }
  auto point(Eigen::Index i) const { return points_.row(i).transpose(); }
  std::span<const TrueValues> worths() const {
    return {worths_.data(), static_cast<std::size_t>(size_)};
  }
  const TrueValues& worth(Eigen::Index i) const { return worths_[static_cast<std::size_t>(i)]; }

  /// Keeps these points, in this order; an index may be repeated.
  void keep(std::span<const Eigen::Index> chosen);

  void clear() { size_ = 0; }

 private:
  Evaluator& evaluator_;
  Matrix points_;
  std::vector<TrueValues> worths_;
  Eigen::Index size_ = 0;
};

}  // namespace ricochet::fireworks
