#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/carrier_track/paper/cases.h"
#include "problems/carrier_track/paper/reading.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/scene.h"

/// The numbers that the paper does not give, and the scene that a reading makes of them.
namespace ricochet::carrier_track::inline paper {

/// A number that the paper does not give, within what a braiding machine may have.
struct OpenConstant {
  std::string_view name;
  std::string_view unit;
  double lower, upper;
  bool logarithmic;               ///< whether its size is unknown, rather than its value
  std::optional<double> natural;  ///< what the paper or the scene suggests
  std::string_view why;           ///< these bounds, and this natural value
};

/// Its value at a place within its bounds, in [0, 1].
double value_at(const OpenConstant& constant, double share);

/// And back; the nearer end for a value beyond the bounds.
double share_of(const OpenConstant& constant, double value);

/// All of them, in the order in which constants are kept everywhere.
const std::vector<OpenConstant>& open_constants();

/// Where they are in open_constants().
enum class Open : std::size_t {
  pull,
  normal_force,
  centrifugal_mass_radius,
  clearance,
  start_share,
  start_velocity,
  phase,
  revolutions,
  seconds,
  slowest,
  pull_phase,
  disturbance_frequency,
  disturbance_phase,
  crossing_angle,
  contact_speed
};
inline constexpr std::size_t open_size = 15;

/// Of those that a reading has a use for.
std::vector<Open> open_of(const Reading& reading);

bool contains(const std::vector<Open>& constants, Open constant);

/// A value for every open constant; those that the reading has no use for do not matter.
template <class Scalar>
using BasicConstants = std::array<Scalar, open_size>;
using Constants = BasicConstants<double>;

/// Where a search begins: the natural values, and in the middle of their bounds those that have
/// none or whose natural value is as good as none at all.
Constants natural_constants();

inline constexpr double gravity = 9.81;                  ///< [m/s^2]
inline constexpr double slider_mass_radius = 3.2566e-4;  ///< [kg m], (m_s1 + m_s2) L sin(theta/2)

/// Of fidelity compliant, for Recovery::contact_speed [N/m^1.5]: so stiff that the carrier's weight
/// presses it in by 24 micrometres.
inline constexpr double calibration_stiffness = 1e8;

/// The scene of a case at a reading and its constants, omega still open.
template <class Scalar>
BasicScene<Scalar> scene_of(const Case& a_case, const Reading& reading,
                            const BasicConstants<Scalar>& constants) {
  const auto number = [](double x) { return constant<Scalar>(x); };
  const auto the = [&](Open open) { return constants[static_cast<std::size_t>(open)]; };
  BasicScene<Scalar> scene;
  scene.mass = number(reading.base == Base::spindle ? 1.8 : 1.2);
  scene.wall_lower = number(0.0);
  scene.wall_upper = the(Open::clearance);
  scene.pull = the(Open::pull);
  scene.pull_rotates = reading.tension != Tension::constant;
  if (reading.tension == Tension::phased) scene.pull_phase = the(Open::pull_phase);
  scene.centrifugal = reading.forcing;
  scene.centrifugal_mass_radius = the(Open::centrifugal_mass_radius);
  scene.slider_mass_radius = number(slider_mass_radius);
  scene.phase = the(Open::phase);
  scene.start_position = the(Open::start_share) * the(Open::clearance);
  scene.start_velocity = the(Open::start_velocity);
  if (reading.window == WindowUnit::revolutions) {
    scene.window = Revolutions{value(the(Open::revolutions))};
  } else {
    scene.window = Seconds{value(the(Open::seconds))};
  }
  scene.slowest = the(Open::slowest);

  double restitution = a_case.restitution;
  if (reading.recovery == Recovery::hunt_crossley) {
    restitution = returned_restitution(dissipation(ContactLaw::hunt_crossley, a_case.restitution));
  }
  scene.friction = number(a_case.friction);
  scene.normal_force = the(Open::normal_force);
  if (reading.normal_force == NormalForce::weight) scene.normal_force = number(1.2 * gravity);
  scene.contact_friction = reading.normal_force == NormalForce::contact;
  scene.restitution_lower = scene.restitution_upper = number(restitution);
  if (reading.recovery == Recovery::contact_speed) {
    scene.fidelity = Fidelity::compliant;
    scene.stiffness = calibration_stiffness;
    scene.contact_speed = value(the(Open::contact_speed));
  }

  scene.disturbance = number(a_case.disturbance);
  if (reading.disturbance == DisturbanceKind::acceleration) scene.disturbance *= scene.mass;
  if (reading.disturbance == DisturbanceKind::frequency) {
    scene.disturbance_frequency = the(Open::disturbance_frequency);
  }
  if (reading.disturbance == DisturbanceKind::phase) {
    scene.disturbance_phase = the(Open::disturbance_phase);
  }
  if (reading.rule != Rule::impacts) scene.rule = CountRule::peaks;
  if (reading.rule == Rule::peaks_100um) scene.peak_low = number(1e-4);
  return scene;
}

/// That scene at a speed [rad/s] > 0. A crossing turns the speed into a profile; it carries no
/// derivatives.
Scene scene_at(const Scene& scene, const Reading& reading, const Constants& constants,
               double omega);

}  // namespace ricochet::carrier_track::inline paper
