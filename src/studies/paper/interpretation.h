#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/scene.h"

/// The questions that the paper leaves open (docs/paper.md). The first answer to each is that
/// of the simplest model.
namespace ricochet::carrier_track::inline paper {

/// The direction of the yarn tension T_1.
enum class Tension {
  constant,  ///< fixed: phi is a constant
  rotating,  ///< turns with the driver plate: phi = alpha
  phased     ///< as rotating, ahead by a constant angle
};

/// The unit in which the window t_0 is fixed.
enum class WindowUnit { revolutions, seconds };

/// The meaning of 0.1 cos t and cos t.
enum class DisturbanceKind {
  force,         ///< newtons, at 1 rad/s, from phase 0
  acceleration,  ///< m/s^2
  frequency,     ///< newtons at another frequency
  phase          ///< newtons at 1 rad/s from another phase
};

/// The normal force that the friction coefficient multiplies.
enum class NormalForce {
  constant,  ///< a separate constant
  weight,    ///< m g
  contact    ///< a separate constant, plus the wall's force in contact
};

/// The path of the carrier.
enum class Transition {
  plain,    ///< a circle
  crossing  ///< with the straight crossing EF of equations (3)-(5) once every half turn
};

/// The meaning of C_r.
enum class Recovery {
  restitution,    ///< Newton's: the ratio of the speeds
  hunt_crossley,  ///< the c of the law's damping 3 (1 - c) / 2, whose restitution is higher
  contact_speed   ///< the same with one approach speed for all impacts in the damping
};

/// The events that count.
enum class Rule {
  impacts,     ///< impacts on either wall, faster than a limit
  peaks_1mm,   ///< maxima of x from 3 mm on or up to 1 mm, as in (33)
  peaks_100um  ///< the same up to 0.1 mm, as in the sentence below (33)
};

/// The mass m_c of the spindle's base.
enum class Base {
  remainder,  ///< 0.6 kg: m = 1.2 kg is the whole carrier's
  spindle     ///< 1.2 kg: with the sliders the carrier has 1.8 kg
};

/// When the events are counted.
enum class Counted {
  from_start,  ///< in the window, which begins with the motion
  later,       ///< in turns a to b: the window begins some turns later
  long_run     ///< in turns 20 to 30, as a mean for as many turns as the window has
};

/// One answer to each question.
struct Interpretation {
  Centrifugal forcing = Centrifugal::projected;
  Tension tension = Tension::constant;
  WindowUnit window = WindowUnit::revolutions;
  DisturbanceKind disturbance = DisturbanceKind::force;
  NormalForce normal_force = NormalForce::constant;
  Transition transition = Transition::plain;
  Recovery recovery = Recovery::restitution;
  Rule rule = Rule::impacts;
  Base base = Base::remainder;
  Counted counted = Counted::from_start;

  bool operator==(const Interpretation&) const = default;
};

/// Forcing, tension and window, and every other answer except the first:
/// "projected-constant-revolutions-weight".
std::string name_of(const Interpretation& interpretation);

/// Describes it in a sentence.
std::string description_of(const Interpretation& interpretation);

/// An interpretation's answer to one of the questions.
struct Answer {
  std::string question;
  std::string answer;
};

/// To all of them, in the order of the members.
std::vector<Answer> answers_of(const Interpretation& interpretation);

/// Every combination of forcing, tension and window with the first answers to the others: 18.
std::vector<Interpretation> core_interpretations();

/// The interpretation with one answer to one of the other questions changed: 13 for a core
/// interpretation, 12 if its window is not a number of revolutions, as a later one must be.
std::vector<Interpretation> variations(const Interpretation& interpretation);

/// The interpretation of a name that name_of() gives. Throws InputError for any other, and for one
/// whose answers exclude each other.
Interpretation find_interpretation(const std::string& name);

// The numbers that the paper does not give, and the scene of an interpretation for given values.

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
  contact_speed,
  first_turn
};
inline constexpr std::size_t unknown_size = 16;

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

/// The turns that count in the long run.
inline constexpr double settled_turn = 20, last_turn = 30;

/// The scene of a case for an interpretation and its parameters; omega is not set. Its window ends
/// where the count does; see counts_of().
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
  if (interpretation.counted == Counted::long_run) {
    scene.window = Revolutions{last_turn};
  } else if (interpretation.window == WindowUnit::revolutions) {
    const bool later = interpretation.counted == Counted::later;
    scene.window = Revolutions{(later ? value(the(Unknown::first_turn)) : 0) +
                               value(the(Unknown::revolutions))};
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

/// An interpretation with a value for each of its parameters, and which of them a fit may change.
struct Parameterisation {
  Interpretation interpretation;
  std::vector<Unknown> free;
  Constants constants;  ///< of the free ones where a fit starts, or what it found
};

/// An interpretation of the paper with fitted parameters, and their origin. Those that are not free
/// are natural.
struct FittedInterpretation : Parameterisation {
  std::string provenance;   ///< in a sentence
  std::string name;         ///< name_of(interpretation)
  std::string description;  ///< description_of(interpretation)
  Scene scene;              ///< of every case, but for restitution, friction and disturbance
};

/// The file text: TOML with the interpretation, its parameters in SI units, which of them are
/// fitted, and the provenance.
std::string write_fitted_interpretation(const FittedInterpretation& fitted);

/// Throws InputError if the text is invalid, if parameters lie outside their bounds, or if the
/// interpretation needs more than a scene: a crossing, or a case's numbers in other units.
FittedInterpretation parse_fitted_interpretation(const std::string& text,
                                                 const std::string& origin);

/// Puts the parts together. Throws InputError as above.
FittedInterpretation fitted_interpretation(const Parameterisation& fit, std::string provenance,
                                           const std::string& origin);

/// Returns true if the scenes of all cases differ only in restitution, friction and disturbance.
bool is_one_scene(const Interpretation& interpretation);

/// The interpretation that every command uses: interpretation.toml, which `ricochet calibrate`
/// regenerates.
const FittedInterpretation& default_interpretation();

}  // namespace ricochet::carrier_track::inline paper
