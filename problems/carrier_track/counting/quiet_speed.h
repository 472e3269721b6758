#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "ricochet/machine.h"

/// Sensitivity of the fastest quiet speed to the constants of a machine, none of which is known
/// exactly, and to what counts as an impact.
namespace ricochet::carrier_track::inline answer {

/// Throws InputError if the scene is not valid, if omega [rad/s] is not > 0, or for less than one
/// machine: what the functions below are given.
void check_near(const Scene& scene, double omega, int machines = 1);

/// The constants of a scene that are not zero, by their keys; `clearance` stands for the walls,
/// because only their distance matters. Limits of the rule and angles are not included.
std::vector<std::string> constants_of(const Scene& scene);

/// The scene with the constant of that key multiplied by `factor` > 0. Restitutions never exceed 1,
/// and the start keeps its share of the clearance. An unknown key changes nothing.
Scene scaled(Scene scene, const std::string& key, double factor);

/// The speed [rad/s] that best divides the speeds that keep the limit from those that exceed it,
/// between 2/3 and 3/2 of `omega`, with a relative accuracy of 1/50,000; in the long run the
/// border, exactly. Nothing if all speeds keep it or all exceed it.
std::optional<double> divide_near(const Scene& scene, const Limit& limit, double omega);

struct Sensitivity {
  std::string key;
  double percent;  ///< rise of the dividing speed [%] per 1 % rise of the constant
};

/// The sensitivities to every constant and, where impacts count, to the counting limit, which is no
/// part of the machine but moves the speed as a constant does: from changes by 1 % up and down; the
/// largest first. Omits one if a changed scene has no dividing speed. Throws InputError, see
/// check_near().
std::vector<Sensitivity> sensitivities(const Scene& scene, const Limit& limit, double omega);

/// Dividing speeds of machines whose constants each deviate by up to a tolerance.
struct ToleranceRange {
  double lowest, highest;  ///< [rad/s]
  int machines;            ///< number drawn
  int without;             ///< number without a dividing speed between 2/3 and 3/2 of omega
};

/// The range of the machines' dividing speeds near `omega`. Nothing if no machine has one.
std::optional<ToleranceRange> divide_range(const std::vector<Scene>& machines, const Limit& limit,
                                           double omega);

/// Draws machines with every constant multiplied by an independent, uniform factor within 1 -
/// tolerance .. 1 + tolerance; tolerance within 0..0.5. The same seed draws the same machines.
/// Nothing if no machine has a dividing speed. Throws InputError for a tolerance out of its range,
/// and as check_near() does.
std::optional<ToleranceRange> tolerance_range(const Scene& scene, const Limit& limit, double omega,
                                              double tolerance, int machines, std::uint64_t seed);

/// The dividing speed of a machine whose file says how uncertain its numbers are.
struct UncertainDivide {
  struct Effect {
    std::string key;  ///< with its table
    double change;    ///< [rad/s], for the number at value + plus_minus; to first order
  };
  std::vector<Effect> effects;  ///< the largest first; without numbers that have no dividing speed
  double first_order;           ///< [rad/s], sum of the sizes of all effects: the farthest change
  ToleranceRange range;         ///< of machines with all uncertain numbers drawn at once
};

/// Changes the uncertain numbers of a file, each alone to both ends and then all at once, drawn
/// uniformly for `machines` machines. `omega` [rad/s] is the dividing speed at the values. The same
/// seed draws the same machines. Nothing if no number is uncertain, or if no drawn machine has a
/// dividing speed between 2/3 and 3/2 of omega. Throws InputError if a drawn machine is not valid.
std::optional<UncertainDivide> uncertain_divide(const SceneFile& file, const Limit& limit,
                                                double omega, int machines, std::uint64_t seed);

// Limits that are about the motion in the long run, and not about a window after a start.

/// [rad/s], where the speeds of a limit in the long run begin.
inline constexpr double slowest_of_a_range = 0.01;

/// Whether a limit of this scene is about the long run; see Measure.
inline bool is_of_the_long_run(const Scene& scene, const Limit& limit) {
  return limit.measure == Measure::collisions_per_turn && has_regimes(scene);
}

/// The limit that quiet_speed() begins with: the one that is asked for, or that of a turn.
inline Limit limit_of(const QuietSpeedOptions& options) {
  return options.limit.value_or(Limit{Measure::collisions_per_turn, quiet_per_turn});
}

}  // namespace ricochet::carrier_track::inline answer
