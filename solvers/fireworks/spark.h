#pragma once

#include <span>

#include "ricochet/random.h"

/// How the point x of a firework becomes that of a spark. `moved` are the coordinates that change.
/// A spark may lie outside the box.
namespace ricochet::fireworks {

/// How many draws the offsets of a spark use.
enum class Offsets {
  each,  ///< one draw for each coordinate, as equation (26) is printed
  one,   ///< the same draw for all, as in Tan & Zhu
};

/// Adds amplitude * unit_k * U(-1, 1) to the coordinates: equation (26).
void displace(Vector& x, std::span<const Eigen::Index> moved, double amplitude, const Vector& unit,
              Offsets offsets, Random& random);

/// Multiplies the coordinates by one g ~ N(1, 1): equation (27). Biased towards the origin.
void multiply(Vector& x, std::span<const Eigen::Index> moved, Random& random);

/// Adds (best - x) e to the coordinates, with one e ~ N(0, 1): the Gaussian spark of EFWA.
void approach(Vector& x, std::span<const Eigen::Index> moved, const Vector& best, Random& random);

/// Adds the mean of the best sparks less the mean of the worst ones: the guiding spark (Li, Zheng
/// and Tan, IEEE Transactions on Evolutionary Computation 21 (2017) 153). A row of `sparks` is a
/// point; `order` lists the rows from the best to the worst; a part `share` in (0, 1] of them is
/// taken from either end, at least one. Adds `times` this difference.
void guide(Vector& x, const Eigen::Ref<const Matrix>& sparks, std::span<const Eigen::Index> order,
           double share, double times = 1);

/// The mean of the best sparks that guide() takes.
Vector mean_of_best(const Eigen::Ref<const Matrix>& sparks, std::span<const Eigen::Index> order,
                    double share);

}  // namespace ricochet::fireworks
