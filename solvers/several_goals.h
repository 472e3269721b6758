#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ricochet/vector.h"

/// Multi-objective optimisation: all goals are minimised; the result is a Pareto front.
namespace ricochet {

/// Goals over the unit cube. `evaluate` returns one finite number for each goal.
struct SeveralGoals {
  Eigen::Index variables;
  Eigen::Index goals;
  std::function<Vector(const Vector& u)> evaluate;
};

struct FrontPoint {
  Vector u;  ///< in the unit cube
  Vector goals;
};

/// Mutually non-dominated points, in the order in which they were found.
using Front = std::vector<FrontPoint>;

/// Returns true if `a` is nowhere worse than `b`, and somewhere better.
bool dominates(const Vector& a, const Vector& b);

/// Adds the point, unless a point of the front is as good in every goal, and removes the points
/// that it dominates.
void add(Front& front, FrontPoint point);

struct FrontSearch {
  int population;      ///< a multiple of 4, at least 8
  int generations;     ///< after the first, which is `starts` and points uniform in the cube
  std::uint64_t seed;  ///< the same seed gives the same front
  std::vector<Vector> starts;  ///< at most `population` points
};

/// The front of all points that NSGA-II (Deb et al., IEEE Trans. Evol. Comput. 6 (2002) 182-197;
/// doi 10.1109/4235.996017) evaluates: (generations + 1) times the population. Exceptions of
/// `evaluate` are passed on. Throws InputError if this build has no pagmo.
Front nsga2_front(const SeveralGoals& problem, const FrontSearch& search);

/// The hypervolume that the front dominates below the reference. Points that are not better than
/// the reference in every goal add nothing. Throws InputError if this build has no pagmo.
double hypervolume(const Front& front, const Vector& reference);

}  // namespace ricochet
