#pragma once

#include <span>

#include "src/core/random.h"

/// How a firework's point x becomes a spark's. `moved` are the coordinates that change. A spark may
/// come to lie outside the box.
namespace ricochet::fireworks {

/// What the coordinates of a spark are moved by.
enum class Offsets {
  each,  ///< every one by a draw of its own, as equation (26) is printed
  one,   ///< all by the same draw, as Tan & Zhu have it
};

/// Adds amplitude * unit_k * U(-1, 1) to the coordinates: equation (26).
void displace(Vector& x, std::span<const Eigen::Index> moved, double amplitude, const Vector& unit,
              Offsets offsets, Random& random);

/// Multiplies the coordinates by one g ~ N(1, 1): equation (27). Draws towards the origin.
void multiply(Vector& x, std::span<const Eigen::Index> moved, Random& random);

/// Adds (best - x) e to the coordinates, with one e ~ N(0, 1): the Gaussian spark of EFWA.
void approach(Vector& x, std::span<const Eigen::Index> moved, const Vector& best, Random& random);

/// Adds what leads from the worst sparks to the best ones, the difference of their means: the
/// guiding spark (Li, Zheng and Tan, IEEE Transactions on Evolutionary Computation 21 (2017) 153).
/// A row of `sparks` is a point; `order` names the rows from the best to the worst; `share` in (0,
/// 1] of them is taken from either end, at least one.
void guide(Vector& x, const Eigen::Ref<const Matrix>& sparks, std::span<const Eigen::Index> order,
           double share);

}  // namespace ricochet::fireworks
