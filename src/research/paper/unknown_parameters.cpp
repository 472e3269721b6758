#include "src/research/paper/unknown_parameters.h"

#include <algorithm>
#include <cmath>

#include "src/research/paper/crossing_motion.h"

namespace ricochet::carrier_track::inline paper {

double value_at(const UnknownParameter& c, double share) {
  if (c.logarithmic) return c.lower * std::pow(c.upper / c.lower, share);
  return c.lower + share * (c.upper - c.lower);
}

double share_of(const UnknownParameter& c, double value) {
  const double share = c.logarithmic ? std::log(value / c.lower) / std::log(c.upper / c.lower)
                                     : (value - c.lower) / (c.upper - c.lower);
  return std::clamp(share, 0.0, 1.0);
}

const std::vector<UnknownParameter>& unknown_parameters() {
  constexpr double turn = 2 * std::numbers::pi;
  static const std::vector<UnknownParameter> constants = {
      {"pull", "N", 0.01, 40, true, 0.01,
       "a yarn is braided under some newtons; drawn straight across the track, it has none along "
       "x"},
      {"normal_force", "N", 0.01, 60, true, 1.2 * gravity,
       "to five times the weight m g, which is natural"},
      {"centrifugal_mass_radius", "kg m", 0.01, 2.4, true, 0.078,
       "1.2 kg from a slider's arm, 8 mm, to the radius of a machine, 2 m; m r_c is natural"},
      {"clearance", "m", 5e-5, 1e-2, true, 2e-3,
       "from a tight fit to the play of a worn track; 2 mm lie between the limits of (33)"},
      {"start_share", "", 0, 1, false, 0.5, "of the clearance; in the middle is natural"},
      {"start_velocity", "m/s", -0.6, 0.6, false, 0.0,
       "no faster than the carrier goes round at 9 rad/s; at rest is natural"},
      {"phase", "rad", 0, turn, false, 0.0, "any angle; (31) starts at 0"},
      {"revolutions", "turns", 0.3, 4, true, 1.0, "from a part of a turn to some; one is natural"},
      {"seconds", "s", 0.3, 8, true, turn, "as long as a turn at 0.8 to 20 rad/s; at 1 rad/s"},
      {"counting_limit", "m/s", 1e-7, 0.2, true, std::nullopt,
       "from what a computation resolves to what is heard"},
      {"pull_phase", "rad", 0, turn, false, 0.0, "any angle"},
      {"disturbance_frequency", "rad/s", 0.3, 60, true, 1.0,
       "from the slowest to the fastest shaft; the paper's is 1"},
      {"disturbance_phase", "rad", 0, turn, false, 0.0, "any angle; the paper's is 0"},
      {"crossing_angle", "rad", 0.05, 0.8, false, 0.4,
       "of the plate, half a crossing: no crossing is longer than half the half turn"},
      {"contact_speed", "m/s", 1e-3, 1, true, 0.1, "as fast as impacts are"}};
  return constants;
}

std::vector<Unknown> unknowns_of(const Interpretation& interpretation) {
  const bool impacts = interpretation.rule == Rule::impacts;
  const auto used = [&](Unknown open) {
    switch (open) {
      case Unknown::normal_force:
        return interpretation.normal_force != NormalForce::weight;
      case Unknown::revolutions:
        return interpretation.window == WindowUnit::revolutions;
      case Unknown::seconds:
        return interpretation.window == WindowUnit::seconds;
      case Unknown::counting_limit:
        return impacts;
      case Unknown::pull_phase:
        return interpretation.tension == Tension::phased;
      case Unknown::disturbance_frequency:
        return interpretation.disturbance == DisturbanceKind::frequency;
      case Unknown::disturbance_phase:
        return interpretation.disturbance == DisturbanceKind::phase;
      case Unknown::crossing_angle:
        return interpretation.transition == Transition::crossing;
      case Unknown::contact_speed:
        return interpretation.recovery == Recovery::contact_speed;
      default:
        return true;
    }
  };
  std::vector<Unknown> open;
  for (std::size_t i = 0; i < unknown_size; ++i) {
    if (used(static_cast<Unknown>(i))) open.push_back(static_cast<Unknown>(i));
  }
  return open;
}

bool contains(const std::vector<Unknown>& constants, Unknown constant) {
  return std::find(constants.begin(), constants.end(), constant) != constants.end();
}

Constants natural_constants() {
  Constants constants{};
  for (std::size_t i = 0; i < unknown_size; ++i) {
    const UnknownParameter& c = unknown_parameters()[i];
    const bool searched = !c.natural || (c.logarithmic && *c.natural == c.lower);
    constants[i] = searched ? std::sqrt(c.lower * c.upper) : *c.natural;
  }
  return constants;
}

Scene scene_at(const Scene& scene, const Interpretation& interpretation, const Constants& constants,
               double omega) {
  Scene result = at_speed(scene, omega);
  if (interpretation.transition == Transition::crossing) {
    const double turns = interpretation.window == WindowUnit::revolutions
                             ? std::get<Revolutions>(scene.window).count
                             : omega * std::get<Seconds>(scene.window).count / 6.0;
    result.profile = crossing_profile(
        omega, constants[static_cast<std::size_t>(Unknown::crossing_angle)], turns);
  }
  return result;
}

}  // namespace ricochet::carrier_track::inline paper
