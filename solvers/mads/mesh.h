#pragma once

#include <algorithm>
#include <cmath>

namespace ricochet {

/// Mesh size in the unit box and distance of a poll from its centre: 4^-index and 2^-index, so that
/// a finer mesh offers more directions (Abramson, Audet, Dennis and Le Digabel 2009, doi
/// 10.1137/080716980, table 3.1).
class Mesh {
 public:
  explicit Mesh(int index = 2) : index_(index) {}  // a quarter of the box, as in NLopt's solvers

  int index() const { return index_; }
  double spacing() const { return std::ldexp(1.0, -2 * index_); }
  double poll_size() const { return std::ldexp(1.0, -index_); }

  void refine() { ++index_; }
  void coarsen() { index_ = std::max(index_ - 1, coarsest); }

 private:
  static constexpr int coarsest = 1;  // polls at half the box

  int index_;
};

}  // namespace ricochet
