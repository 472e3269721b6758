#pragma once

#include <algorithm>
#include <cmath>

namespace ricochet {

/// How far apart the points of a mesh in the unit box lie, and how far from its centre a poll
/// looks: 4^-index and 2^-index, so that a finer mesh offers ever more directions (Abramson, Audet,
/// Dennis and Le Digabel 2009, doi 10.1137/080716980, table 3.1).
class Mesh {
 public:
  explicit Mesh(int index = 2) : index_(index) {}  // a quarter of the box, as NLopt's solvers do

  int index() const { return index_; }
  double spacing() const { return std::ldexp(1.0, -2 * index_); }
  double poll_size() const { return std::ldexp(1.0, -index_); }

  void refine() { ++index_; }
  void coarsen() { index_ = std::max(index_ - 1, coarsest); }

 private:
  static constexpr int coarsest = 1;  // polls half the box around

  int index_;
};

}  // namespace ricochet
