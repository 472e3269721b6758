#pragma once

#include <ceres/jet.h>

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

#include "problems/carrier_track/flight/profile_forces.h"
#include "problems/carrier_track/gradients/leg_record.h"
#include "problems/carrier_track/models/impact_model.h"
#include "problems/carrier_track/models/observer_pair.h"
#include "problems/carrier_track/scene/lifted.h"

/// What an adjoint sweep needs of a sum over the events of a motion, an EventSum of event_sums.h.
namespace ricochet::carrier_track::inline gradients {

/// The derivatives of the term of one event with respect to its time [s] and to its state: the
/// approach speed of an impact [m/s], or the position of a turning point [m].
struct EventTerm {
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  Eigen::Matrix2d curvature = Eigen::Matrix2d::Zero();
};

/// A sum over a motion, and the motion.
struct SummedMotion {
  double value;
  std::vector<MotionLeg> legs;
};

/// Simulates a valid scene of fidelity impact with a speed profile.
template <class EventSum>
SummedMotion summed_motion(const EventSum& of, const Scene& scene) {
  auto sum = of.over(scene);
  LegRecord record;
  ObserverPair both(sum, record);
  ImpactModel<double, ProfileForces<double>>(scene).run(both);
  return {sum.total(), std::move(record).legs()};
}

namespace detail {

/// What the event at the end of a leg adds to an empty sum.
template <class Scalar, class Sum>
Scalar term_of(Sum sum, const MotionLeg& leg, const Scalar& time, const Scalar& state) {
  if (leg.end == LegEnd::impact) {
    sum.impact(time, leg.direction > 0 ? Wall::upper : Wall::lower, state);
    if (leg.peak) sum.peak(time, constant<Scalar>(leg.position));
  } else if (leg.peak) {
    sum.peak(time, state);
  }
  return sum.total();
}

/// Copies the derivatives of a term.
inline void keep(const ceres::Jet<double, 2>& term, EventTerm& result) {
  result.slope = term.v;
}

inline void keep(const ceres::Jet<ceres::Jet<double, 2>, 2>& term, EventTerm& result) {
  for (int i = 0; i < 2; ++i) {
    result.slope[i] = term.v[i].a;
    result.curvature.row(i) = term.v[i].v;
  }
}

/// A dual with derivatives up to an order along a direction, 0 or 1.
template <int order>
auto input(double value, int direction) {
  using Dual = ceres::Jet<double, 2>;
  if constexpr (order == 1) {
    return Dual(value, direction);
  } else {
    return ceres::Jet<Dual, 2>(Dual(value, direction), direction);
  }
}

}  // namespace detail

/// The derivatives of the terms up to an order, 1 or 2, one for each leg of a motion of `scene`.
template <int order, class EventSum>
std::vector<EventTerm> event_terms(const EventSum& of, Scene scene,
                                   const std::vector<MotionLeg>& legs) {
  using Dual = decltype(detail::input<order>(0, 0));
  scene.profile.clear();
  const BasicScene<Dual> constants = lifted<Dual>(scene);
  const auto nothing = of.over(constants);
  std::vector<EventTerm> terms(legs.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const MotionLeg& leg = legs[i];
    if (leg.end == LegEnd::cut) continue;
    const double state = leg.end == LegEnd::impact ? leg.speed : leg.position;
    const Dual term =
        detail::term_of(nothing, leg, detail::input<order>(leg.start + leg.duration, 0),
                        detail::input<order>(state, 1));
    detail::keep(term, terms[i]);
  }
  return terms;
}

}  // namespace ricochet::carrier_track::inline gradients
