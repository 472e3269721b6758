#pragma once

#include <span>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/random.h"

/// Selection of the points that survive a generation.
namespace ricochet::fireworks {

/// Which of several equally good points is the best.
enum class Ties {
  first,  ///< the one evaluated first: the best firework never moves along a plateau
  any,    ///< one of them, drawn uniformly
};

/// How the survivors other than the best are drawn.
enum class Others {
  by_distance,  ///< with probability proportional to the sum of distances, equations (29) and (30)
  uniform,      ///< all equally likely, as in EFWA
};

struct SelectionOptions {
  Ties ties = Ties::first;
  Others others = Others::by_distance;
  bool replacement = true;  ///< a point, also the best, may be selected several times
};

/// Index of the best point by the feasibility rules, see better(); `worths` has at least one entry.
Eigen::Index best_of(std::span<const TrueValues> worths, Ties ties, Random& random);

/// Equation (29), the numerators of (30): for every point (row), the sum of its Euclidean distances
/// to all points. Returns all 1 if all sums are 0, because (30) would be 0 / 0, or if one is
/// infinite.
Vector distance_sums(const Eigen::Ref<const Matrix>& points);

/// Indices of `count` points, the best first, the others drawn. `count` is at most the number of
/// points.
std::vector<Eigen::Index> selected(const Eigen::Ref<const Matrix>& points,
                                   std::span<const TrueValues> worths, int count,
                                   const SelectionOptions& options, Random& random);

}  // namespace ricochet::fireworks
