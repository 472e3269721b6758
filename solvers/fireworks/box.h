#pragma once

#include <vector>

#include "ricochet/random.h"

namespace ricochet::fireworks {

/// How a coordinate outside the box is brought back; one inside stays as it is.
enum class Mapping {
  modulo,  ///< lower + |x| mod (upper - lower), equation (28): just outside [-a, a] maps to near 0
  redraw,  ///< uniform in the box, as in EFWA and its successors
};

/// A problem's box. Coordinates of width 0 are fixed, the others free.
class Box {
 public:
  Box(const Vector& lower, const Vector& upper);

  const Vector& lower() const { return lower_; }
  const Vector& upper() const { return upper_; }
  const Vector& width() const { return width_; }
  const std::vector<Eigen::Index>& free() const { return free_; }

  /// Makes x, of the right length, uniform in the box.
  void draw(Vector& x, Random& random) const;

  /// Brings x back into the box, coordinate by coordinate.
  void bring_back(Vector& x, Mapping mapping, Random& random) const;

  /// Draws each coordinate of x outside the box again: uniform where the box and the centre, which
  /// is in the box, +- amplitude box widths overlap.
  void bring_near(Vector& x, const Vector& centre, double amplitude, Random& random) const;

 private:
  double drawn(Eigen::Index k, Random& random) const;

  Vector lower_, upper_, width_;
  std::vector<Eigen::Index> free_;
};

}  // namespace ricochet::fireworks
