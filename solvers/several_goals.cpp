#include "solvers/several_goals.h"

#include <algorithm>
#include <utility>

#ifndef RICOCHET_HAS_PAGMO
#include "ricochet/error.h"
#endif

namespace ricochet {

bool dominates(const Vector& a, const Vector& b) {
  return (a.array() <= b.array()).all() && (a.array() < b.array()).any();
}

void add(Front& front, FrontPoint point) {
  const auto as_good = [&](const FrontPoint& other) {
    return (other.goals.array() <= point.goals.array()).all();
  };
  if (std::any_of(front.begin(), front.end(), as_good)) return;
  std::erase_if(front,
                [&](const FrontPoint& other) { return dominates(point.goals, other.goals); });
  front.push_back(std::move(point));
}

#ifndef RICOCHET_HAS_PAGMO
Front nsga2_front(const SeveralGoals& /*problem*/, const FrontSearch& /*search*/) {
  throw InputError("this build has no pagmo, which searches for fronts");
}

double hypervolume(const Front& /*front*/, const Vector& /*reference*/) {
  throw InputError("this build has no pagmo, which measures fronts");
}
#endif

}  // namespace ricochet
