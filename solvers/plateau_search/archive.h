#pragma once

#include <cstddef>
#include <vector>

#include "src/core/problem.h"

namespace ricochet::drifting {

/// The last points that a search has seen, to foretell what another one is worth.
class Archive {
 public:
  Archive(Eigen::Index n, std::size_t size);

  /// Forgets the oldest point where it is full.
  void add(const Vector& u, const Truth& truth);

  /// What the nearest point in it is worth; it must hold one.
  const Truth& foretold(const Vector& u) const;

  bool empty() const { return count_ == 0; }

 private:
  Matrix points_;  // n x size
  std::vector<Truth> truths_;
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace ricochet::drifting
