#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/scene/enum_names.h"
#include "ricochet/scene.h"

/// The questions that the paper leaves open (paper.md, section 5). The first answer to each is that
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

/// To all nine, in the order of the members.
std::vector<Answer> answers_of(const Interpretation& interpretation);

/// Every combination of forcing, tension and window with the first answers to the others: 18.
std::vector<Interpretation> core_interpretations();

/// The interpretation with one answer to one of the other questions changed: 11 for a core
/// interpretation.
std::vector<Interpretation> variations(const Interpretation& interpretation);

/// The interpretation of a name that name_of() gives. Throws InputError for any other.
Interpretation find_interpretation(const std::string& name);

}  // namespace ricochet::carrier_track::inline paper
