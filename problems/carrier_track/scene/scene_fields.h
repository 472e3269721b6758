#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ricochet/scene.h"
#include "src/core/fields.h"

/// The list of all fields of a scene's file. Reading, writing, checking, conversion to dual numbers
/// and the perturbation that tests counts all use it, in its order. Rules that concern several
/// fields at once are in the file that applies them.
namespace ricochet::carrier_track::inline scene {

using ricochet::name_of;

/// Limits far beyond any machine. Within them no number of a simulation overflows, and every
/// simulation ends.
inline constexpr double largest_number = 1e15;
inline constexpr double smallest_number = 1e-15;
inline constexpr double fastest_frequency = 1e9;  ///< [rad/s]
inline constexpr double longest_window = 1e6;     ///< in periods of the fastest force
inline constexpr double shortest_leg = 1e-9;      ///< [s], from knot to knot of a speed profile

/// The allowed values of a number of a scene.
namespace ranges {
inline constexpr Range by_rule{};  ///< depends on other fields, see check()
inline constexpr Range finite{.least = -largest_number,
                              .most = largest_number,
                              .words = "a finite number [{}], within -1e15..1e15"};
inline constexpr Range not_negative{.least = 0,
                                    .most = largest_number,
                                    .brief = ">= 0",
                                    .words = "a finite number >= 0 [{}], at most 1e15"};
inline constexpr Range positive{.least = smallest_number,
                                .most = largest_number,
                                .brief = "> 0",
                                .words = "a finite number > 0 [{}], within 1e-15..1e15"};
inline constexpr Range frequency{.least = 0,
                                 .most = fastest_frequency,
                                 .brief = ">= 0",
                                 .words = "a finite number >= 0 [{}], at most 1e9"};
inline constexpr Range fraction{.least = 0, .most = 1, .brief = "0..1", .words = "within 0..1"};
}  // namespace ranges

/// How a number changes in a perturbed scene, see perturbed().
enum class Perturbation {
  none,
  relative,
  angle,          ///< by a share of itself or of a radian, whichever is larger
  late_angle,     ///< the same, drawn after all other fields because it was added later
  restitution,    ///< relative, but never above 1
  track,          ///< of wall_lower: both walls and the start change
  with_the_track  ///< changes with wall_lower
};

/// A field of a scene. If it is optional, its default is that of the struct in scene.h.
struct SceneField : Field {
  Perturbation perturbation;

  constexpr SceneField(std::string_view own_key, std::string_view own_unit = "",
                       std::string_view meaning = "", const Range& allowed = {},
                       Perturbation change = Perturbation::none,
                       Presence given = Presence::optional)
      : Field{own_key, own_unit, meaning, allowed, given}, perturbation(change) {}
};

/// The word in a file in place of a number that is not given.
inline constexpr std::string_view open_number = "each";

/// Another way to give centrifugal_mass_radius, which is the mass times it. Only files have it.
inline constexpr SceneField path_radius{"path_radius", "m", "of the carrier's path",
                                        ranges::not_negative};

/// The two numbers of one key: of the lower and of the upper wall.
template <class T>
struct Walls {
  T& lower;
  T& upper;
};
template <class T>
Walls(T&, T&) -> Walls<T>;

/// The speed of the driver plate and its profile, which have one key.
template <class T, class Knots>
struct PlateSpeed {
  T& omega;
  Knots& profile;
};
template <class T, class Knots>
PlateSpeed(T&, Knots&) -> PlateSpeed<T, Knots>;

/// Calls visit(field, member...) for every field of the table [scene], with its member in each of
/// `s`, BasicScenes of any scalars. A key with two members is passed as Walls or PlateSpeed.
template <class Visit, class... S>
void visit_scene_fields(const Visit& visit, S&... s) {
  using namespace ranges;
  using enum Perturbation;
  using enum Presence;
  visit(SceneField{"mass", "kg", "of the yarn carrier", positive, relative, required}, s.mass...);
  visit(SceneField{"wall_lower", "m", "of the track, along x", finite, track, required},
        s.wall_lower...);
  visit(
      SceneField{"wall_upper", "m", "> wall_lower; may be inf", by_rule, with_the_track, required},
      s.wall_upper...);
  visit(SceneField{"restitution", "1", "speed after over before an impact", fraction, restitution,
                   required},
        Walls{s.restitution_lower, s.restitution_upper}...);
  visit(SceneField{"friction", "1", "Coulomb coefficient", not_negative, relative}, s.friction...);
  visit(SceneField{"normal_force", "N", "what the friction coefficient multiplies", not_negative,
                   relative},
        s.normal_force...);
  visit(SceneField{"contact_friction", "", "true: it multiplies a wall's own force, too"},
        s.contact_friction...);
  visit(SceneField{"pull", "N", "of the yarn, towards wall_lower", finite, relative}, s.pull...);
  visit(SceneField{"pull_rotates", "", "true: the pull turns with the driver plate"},
        s.pull_rotates...);
  visit(SceneField{"pull_phase", "rad", "of a pull that rotates", finite, late_angle},
        s.pull_phase...);
  visit(SceneField{"centrifugal", "", "projected, inward or outward"}, s.centrifugal...);
  visit(SceneField{"centrifugal_mass_radius", "kg m",
                   "mass of the carrier times radius of its path", not_negative, relative},
        s.centrifugal_mass_radius...);
  visit(SceneField{"slider_mass_radius", "kg m", "the same of the slider that drives it",
                   not_negative, relative},
        s.slider_mass_radius...);
  visit(SceneField{"phase", "rad", "of the driver plate at the start", finite, angle}, s.phase...);
  visit(SceneField{"disturbance", "N", "amplitude of a force that shakes the carrier", finite,
                   relative},
        s.disturbance...);
  visit(SceneField{"disturbance_frequency", "rad/s", "", frequency, relative},
        s.disturbance_frequency...);
  visit(SceneField{"disturbance_phase", "rad", "", finite, late_angle}, s.disturbance_phase...);
  visit(SceneField{"start_position", "m", "within the walls", by_rule, with_the_track, required},
        s.start_position...);
  visit(SceneField{"start_velocity", "m/s", "", finite, relative}, s.start_velocity...);
  visit(SceneField{"omega", "rad/s", "of the driver plate; or a profile [[time, speed], ...]",
                   by_rule, relative},
        PlateSpeed{s.omega, s.profile}...);
}

/// The same for the table [across] and the struct Across.
template <class Visit, class... Y>
void visit_across_fields(const Visit& visit, Y&... y) {
  using namespace ranges;
  using enum Perturbation;
  using enum Presence;
  visit(SceneField{"pull", "N", "towards wall_upper", finite, relative}, y.pull...);
  visit(SceneField{"wall_lower", "m", "", finite, track, required}, y.wall_lower...);
  visit(
      SceneField{"wall_upper", "m", "> wall_lower; may be inf", by_rule, with_the_track, required},
      y.wall_upper...);
  visit(SceneField{"restitution", "1", "", fraction, restitution, required},
        Walls{y.restitution_lower, y.restitution_upper}...);
  visit(SceneField{"start_position", "m", "", by_rule, with_the_track, required},
        y.start_position...);
  visit(SceneField{"start_velocity", "m/s", "", finite, relative}, y.start_velocity...);
}

/// The same for the table [count]. The limits of the rule are not perturbed: a margin must exceed
/// the effect of a perturbation anyway.
template <class Visit, class... S>
void visit_count_fields(const Visit& visit, S&... s) {
  using namespace ranges;
  visit(SceneField{"rule", "", "impacts or peaks"}, s.rule...);
  visit(
      SceneField{"counting_limit", "m/s", "rule impacts: the slowest impact that counts", positive},
      s.counting_limit...);
  visit(SceneField{"peak_high", "m", "rule peaks: a maximum from here on counts", positive},
        s.peak_high...);
  visit(SceneField{"peak_low", "m", "rule peaks: a maximum up to here counts", positive},
        s.peak_low...);
}

/// The same for the table [model].
template <class Visit, class... S>
void visit_model_fields(const Visit& visit, S&... s) {
  using namespace ranges;
  using enum Perturbation;
  visit(SceneField{"fidelity", "", "impact, compliant, planar or auto"}, s.fidelity...);
  visit(SceneField{"contact_law", "", "of fidelity compliant, as the next three"},
        s.contact_law...);
  visit(SceneField{"stiffness", "N/m^contact_exponent", "", positive, relative}, s.stiffness...);
  visit(SceneField{"contact_exponent", "1", "1 for kelvin-voigt", positive}, s.contact_exponent...);
  visit(SceneField{"contact_speed", "m/s", "", positive, relative}, s.contact_speed...);
}

/// The same for all tables except [across] and [window].
template <class Visit, class... S>
void visit_flat_fields(const Visit& visit, S&... s) {
  visit_scene_fields(visit, s...);
  visit_count_fields(visit, s...);
  visit_model_fields(visit, s...);
}

const EnumNames<Centrifugal>& centrifugal_names();
const EnumNames<CountRule>& rule_names();
const EnumNames<Fidelity>& fidelity_names();
const EnumNames<ContactLaw>& contact_law_names();

/// The names of a value's enumeration.
inline const EnumNames<Centrifugal>& names_of(Centrifugal /*value*/) {
  return centrifugal_names();
}
inline const EnumNames<CountRule>& names_of(CountRule /*value*/) {
  return rule_names();
}
inline const EnumNames<Fidelity>& names_of(Fidelity /*value*/) {
  return fidelity_names();
}
inline const EnumNames<ContactLaw>& names_of(ContactLaw /*value*/) {
  return contact_law_names();
}

/// A table of a scene's file and all keys that it may have.
using TableKeys = std::pair<std::string, std::vector<std::string>>;

/// The tables of a scene's file, in their order, with their keys.
const std::vector<TableKeys>& scene_keys();

}  // namespace ricochet::carrier_track::inline scene
