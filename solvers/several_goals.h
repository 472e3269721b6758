#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "src/core/vector.h"

/// Several goals at once, all to be minimised: what can be had together is a front.
namespace ricochet {

/// Goals over the unit cube. `evaluate` gives so many finite numbers.
struct SeveralGoals {
  Eigen::Index variables;
  Eigen::Index goals;
  std::function<Vector(const Vector& u)> evaluate;
};

struct FrontPoint {
  Vector u;  ///< in the unit cube
  Vector goals;
};

/// Points none of which dominates another, in the order in which they were found.
using Front = std::vector<FrontPoint>;

/// Whether `a` is nowhere worse than `b`, and somewhere better.
bool dominates(const Vector& a, const Vector& b);

/// Adds the point, unless one of the front is as good in every goal, and removes what it dominates.
void add(Front& front, FrontPoint point);

struct FrontSearch {
  int population;      ///< a multiple of 4, at least 8
  int generations;     ///< after the first, which is `starts` and points uniform in the cube
  std::uint64_t seed;  ///< the same seed, the same front
  std::vector<Vector> starts;  ///< at most so many as the population
};

/// The front of all points that NSGA-II (Deb et al., IEEE Trans. Evol. Comput. 6 (2002) 182-197;
/// doi 10.1109/4235.996017) asks for: (generations + 1) times the population. What `evaluate`
/// throws is thrown on. Throws InputError where this build has no pagmo.
Front nsga2_front(const SeveralGoals& problem, const FrontSearch& search);

/// The volume that the front dominates below the reference. Points that are not better than it in
/// every goal add nothing. Throws InputError where this build has no pagmo.
double hypervolume(const Front& front, const Vector& reference);

}  // namespace ricochet
