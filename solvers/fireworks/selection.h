#pragma once

#include <span>
#include <vector>

#include "src/core/problem.h"
#include "src/core/random.h"

/// Who lives on.
namespace ricochet::fireworks {

/// Which of several equally good points is the best.
enum class Ties {
  first,  ///< the one evaluated first: the best firework never moves along a plateau
  any,    ///< one of them, drawn uniformly
};

/// How those are drawn that live on beside the best.
enum class Others {
  by_distance,  ///< with probabilities as their sums of distances, equations (29) and (30)
  uniform,      ///< all alike, as EFWA has it
};

struct SelectionOptions {
  Ties ties = Ties::first;
  Others others = Others::by_distance;
  bool replacement = true;  ///< one point, the best too, may live on several times
};

/// The best by the rules of feasibility, see better(); `worths` has at least one entry.
Eigen::Index best_of(std::span<const Truth> worths, Ties ties, Random& random);

/// Equation (29), the numerators of (30): for every point, a row, the sum of its Euclidean
/// distances to all. All 1 where they are all 0, for then (30) is 0 / 0, or where one is infinite.
Vector distance_sums(const Eigen::Ref<const Matrix>& points);

/// `count` points, the best first; the others are drawn. At least as many points are given.
std::vector<Eigen::Index> selected(const Eigen::Ref<const Matrix>& points,
                                   std::span<const Truth> worths, int count,
                                   const SelectionOptions& options, Random& random);

}  // namespace ricochet::fireworks
