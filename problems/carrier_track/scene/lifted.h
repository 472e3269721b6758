#pragma once

#include <concepts>

#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/scene.h"

/// A scene with all its constants as dual numbers.
namespace ricochet::carrier_track::inline scene {

/// Copies a field of a scene into a scene of another scalar type.
struct LiftField {
  template <class From, class To>
  void operator()(const Field& /*field*/, const From& from, To& to) const {
    if constexpr (std::same_as<From, To>) {
      to = from;
    } else {
      to = constant<To>(from);
    }
  }
  template <class To>
  void operator()(const Field& field, Walls<const double> from, Walls<To> to) const {
    (*this)(field, from.lower, to.lower);
    (*this)(field, from.upper, to.upper);
  }
  template <class To, class From, class Lifted>
  void operator()(const Field& field, PlateSpeed<const double, From> from,
                  PlateSpeed<To, Lifted> to) const {
    (*this)(field, from.omega, to.omega);
    for (const auto& knot : from.profile) {
      to.profile.push_back({knot.time, constant<To>(knot.omega)});
    }
  }
};

/// The same scene with every constant as a Scalar, for instance a dual number.
template <class Scalar>
BasicScene<Scalar> lifted(const Scene& scene) {
  BasicScene<Scalar> result;
  visit_fields(LiftField{}, scene, result);
  result.window = scene.window;
  if (scene.across) visit_across_fields(LiftField{}, *scene.across, result.across.emplace());
  return result;
}

}  // namespace ricochet::carrier_track::inline scene
