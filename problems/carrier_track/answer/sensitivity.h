#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/limit.h"
#include "ricochet/threshold.h"

/// Sensitivity of the fastest quiet speed to the constants of a machine, none of which is known
/// exactly.
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

/// The sensitivities to every constant, from changes by 1 % up and down; the largest first. Omits a
/// constant if a changed scene has no dividing speed. Throws InputError, see check_near().
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

}  // namespace ricochet::carrier_track::inline answer
