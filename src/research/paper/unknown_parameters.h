#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/scene.h"
#include "src/research/paper/interpretation.h"

/// The numbers that the paper does not give, and the scene of an interpretation for given values.
namespace ricochet::carrier_track::inline paper {

/// A number that the paper does not give, with bounds that are plausible for a braiding machine.
struct UnknownParameter {
  std::string_view name;
  std::string_view unit;
  double lower, upper;
  bool logarithmic;               ///< true if its order of magnitude is unknown
  std::optional<double> natural;  ///< value suggested by the paper or the scene
  std::string_view why;           ///< reasons for the bounds and the natural value
};

/// Its value at a place within its bounds, in [0, 1].
double value_at(const UnknownParameter& constant, double share);

/// The inverse; the nearer end for a value beyond the bounds.
double share_of(const UnknownParameter& constant, double value);

/// All of them, in the order in which parameters are stored everywhere.
const std::vector<UnknownParameter>& unknown_parameters();

/// Their indices in unknown_parameters().
enum class Unknown : std::size_t {
  pull,
  normal_force,
  centrifugal_mass_radius,
  clearance,
  start_share,
  start_velocity,
  phase,
  revolutions,
  seconds,
  counting_limit,
  pull_phase,
  disturbance_frequency,
  disturbance_phase,
  crossing_angle,
  contact_speed
};
inline constexpr std::size_t unknown_size = 15;

/// The parameters that an interpretation uses.
std::vector<Unknown> unknowns_of(const Interpretation& interpretation);

bool contains(const std::vector<Unknown>& constants, Unknown constant);

/// Values of all unknown parameters; those that the interpretation does not use have no effect.
template <class Scalar>
using BasicConstants = std::array<Scalar, unknown_size>;
using Constants = BasicConstants<double>;

/// Start of a search: the natural values, and the middle of the bounds for parameters without a
/// natural value or with an unreliable one.
Constants natural_constants();

inline constexpr double gravity = 9.81;                  ///< [m/s^2]
inline constexpr double slider_mass_radius = 3.2566e-4;  ///< [kg m], (m_s1 + m_s2) L sin(theta/2)

/// For fidelity compliant, with Recovery::contact_speed [N/m^1.5]: the carrier's weight compresses
/// it by 24 micrometres.
inline constexpr double calibration_stiffness = 1e8;

/// The scene of a case for an interpretation and its parameters; omega is not set.
template <class Scalar>
BasicScene<Scalar> scene_of(const Case& a_case, const Interpretation& interpretation,
                            const BasicConstants<Scalar>& constants) {
  const auto number = [](double x) { return constant<Scalar>(x); };
  const auto the = [&](Unknown open) { return constants[static_cast<std::size_t>(open)]; };
  BasicScene<Scalar> scene;
  scene.mass = number(interpretation.base == Base::spindle ? 1.8 : 1.2);
  scene.wall_lower = number(0.0);
  scene.wall_upper = the(Unknown::clearance);
  scene.pull = the(Unknown::pull);
  scene.pull_rotates = interpretation.tension != Tension::constant;
  if (interpretation.tension == Tension::phased) scene.pull_phase = the(Unknown::pull_phase);
  scene.centrifugal = interpretation.forcing;
  scene.centrifugal_mass_radius = the(Unknown::centrifugal_mass_radius);
  scene.slider_mass_radius = number(slider_mass_radius);
  scene.phase = the(Unknown::phase);
  scene.start_position = the(Unknown::start_share) * the(Unknown::clearance);
  scene.start_velocity = the(Unknown::start_velocity);
  if (interpretation.window == WindowUnit::revolutions) {
    scene.window = Revolutions{value(the(Unknown::revolutions))};
  } else {
    scene.window = Seconds{value(the(Unknown::seconds))};
  }
  scene.counting_limit = the(Unknown::counting_limit);

  double restitution = a_case.restitution;
  if (interpretation.recovery == Recovery::hunt_crossley) {
    restitution = returned_restitution(dissipation(ContactLaw::hunt_crossley, a_case.restitution));
  }
  scene.friction = number(a_case.friction);
  scene.normal_force = the(Unknown::normal_force);
  if (interpretation.normal_force == NormalForce::weight)
    scene.normal_force = number(1.2 * gravity);
  scene.contact_friction = interpretation.normal_force == NormalForce::contact;
  scene.restitution_lower = scene.restitution_upper = number(restitution);
  if (interpretation.recovery == Recovery::contact_speed) {
    scene.fidelity = Fidelity::compliant;
    scene.stiffness = calibration_stiffness;
    scene.contact_speed = value(the(Unknown::contact_speed));
  }

  scene.disturbance = number(a_case.disturbance);
  if (interpretation.disturbance == DisturbanceKind::acceleration) scene.disturbance *= scene.mass;
  if (interpretation.disturbance == DisturbanceKind::frequency) {
    scene.disturbance_frequency = the(Unknown::disturbance_frequency);
  }
  if (interpretation.disturbance == DisturbanceKind::phase) {
    scene.disturbance_phase = the(Unknown::disturbance_phase);
  }
  if (interpretation.rule != Rule::impacts) scene.rule = CountRule::peaks;
  if (interpretation.rule == Rule::peaks_100um) scene.peak_low = number(1e-4);
  return scene;
}

/// That scene at a speed [rad/s] > 0. A crossing turns the speed into a profile, without
/// derivatives.
Scene scene_at(const Scene& scene, const Interpretation& interpretation, const Constants& constants,
               double omega);

}  // namespace ricochet::carrier_track::inline paper
