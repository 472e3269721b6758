#include "problems/carrier_track/scene/scene_values.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "problems/carrier_track/scene/scene_fields.h"

namespace ricochet::carrier_track::inline scene {

namespace {

constexpr double fastest_plate = 1000;  // [rad/s]

/// What the swing has left after the steady part and friction [N].
double excess(const Scene& scene, double omega) {
  const AppliedForce force = applied_force(scene, omega);
  return force.swing - force.steady - scene.friction * scene.normal_force;
}

}  // namespace

AppliedForce applied_force(const Scene& scene, double omega) {
  const double square = omega * omega;
  const double radial = scene.centrifugal_mass_radius * square;
  double steady = 0;
  std::complex<double> turning = -scene.slider_mass_radius * square;  // times cos alpha
  switch (scene.centrifugal) {
    case Centrifugal::projected:
      turning += radial;
      break;
    case Centrifugal::inward:
      steady -= radial;
      break;
    case Centrifugal::outward:
      steady += radial;
      break;
  }
  if (scene.pull_rotates) {
    turning -= std::polar(1.0, scene.pull_phase) * scene.pull;
  } else {
    steady -= scene.pull;
  }
  double swing = std::abs(turning);
  if (scene.disturbance_frequency > 0) {
    swing += std::abs(scene.disturbance);
  } else {
    steady += scene.disturbance * std::cos(scene.disturbance_phase);
  }
  return {std::abs(steady), swing};
}

std::optional<double> release_speed(const Scene& scene) {
  constexpr double growth = 1.01;
  double held = 0;
  if (excess(scene, held) > 0) return 0;
  double free = 1e-3;
  while (!(excess(scene, free) > 0)) {
    held = free;
    free *= growth;
    if (free > fastest_plate) return std::nullopt;
  }
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (held + free) / 2;
    (excess(scene, middle) > 0 ? free : held) = middle;
  }
  return free;
}

double thrown_speed(const Scene& scene, double omega) {
  const AppliedForce force = applied_force(scene, omega);
  const double left = force.steady + force.swing - scene.friction * scene.normal_force;
  const double clearance = scene.wall_upper - scene.wall_lower;
  return left > 0 ? std::sqrt(2 * left * clearance / scene.mass) : 0;
}

namespace {

/// Changes the fields of a scene as the list in scene_fields.h says.
class FieldPerturbation {
 public:
  FieldPerturbation(double stride, double sign) : stride_(stride), sign_(sign) {}

  void change(const SceneField& field, double& x) {
    switch (field.perturbation) {
      case Perturbation::relative:
        x *= 1 + next();
        break;
      case Perturbation::angle:
      case Perturbation::late_angle:
        x += std::max(1.0, std::abs(x)) * next();
        break;
      case Perturbation::restitution:
        x = std::min(1.0, x * (1 + next()));
        break;
      case Perturbation::none:
      case Perturbation::track:
      case Perturbation::with_the_track:
        break;
    }
  }
  void change(const SceneField& field, Walls<double> x) {
    change(field, x.lower);
    change(field, x.upper);
  }
  template <class Knots>
  void change(const SceneField& field, PlateSpeed<double, Knots> speed) {
    change(field, speed.omega);
    for (auto& knot : speed.profile) change(field, knot.omega);
  }
  void change(const SceneField& field, std::optional<double>& x) {
    if (x) change(field, *x);
  }
  template <class Choice>
  void change(const SceneField& /*field*/, Choice& /*x*/) {}

  /// Changes two walls and a start position. A start on a wall stays on it.
  void change_track(double& lower, double& upper, double& start) {
    double scale = 0;
    for (const double x : {lower, upper, start}) {
      if (std::isfinite(x)) scale = std::max(scale, std::abs(x));
    }
    const bool on_lower = start == lower;
    const bool on_upper = start == upper;
    lower += scale * next();
    upper += scale * next();
    start += scale * next();
    if (on_lower) start = lower;
    if (on_upper) start = upper;
    start = std::max(lower, std::min(start, upper));
  }

 private:
  /// Unequal changes, so that those of a mass and a force do not cancel.
  double next() {
    share_ = std::fmod(share_ + stride_, 1.0);
    const double weight = 2 * share_ - 1;
    return sign_ * perturbation_size * std::copysign(0.5 + 0.5 * std::abs(weight), weight);
  }

  double stride_, sign_;
  double share_ = 0;
};

}  // namespace

Scene perturbed(Scene scene, double stride, double sign) {
  FieldPerturbation perturbation(stride, sign);
  const auto early = [&perturbation](auto& owner) {
    return [&](const SceneField& field, auto&& x) {
      if (field.perturbation == Perturbation::track) {
        perturbation.change_track(owner.wall_lower, owner.wall_upper, owner.start_position);
      } else if (field.perturbation != Perturbation::late_angle) {
        perturbation.change(field, x);
      }
    };
  };
  visit_flat_fields(early(scene), scene);
  if (scene.across) visit_across_fields(early(*scene.across), *scene.across);
  const auto late = [&perturbation](const SceneField& field, auto&& x) {
    if (field.perturbation == Perturbation::late_angle) perturbation.change(field, x);
  };
  visit_flat_fields(late, scene);
  return scene;
}

}  // namespace ricochet::carrier_track::inline scene
