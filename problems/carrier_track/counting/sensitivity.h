#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/limit.h"

/// How much the fastest quiet speed hangs on the constants of a machine, none of which is known
/// exactly.
namespace ricochet::carrier_track::inline counting {

/// The constants of a scene that are not zero, by their keys; `clearance` stands for the walls,
/// whose distance counts. Limits of the rule and angles are none.
std::vector<std::string> constants_of(const Scene& scene);

/// The scene with the constant of that key times `factor` > 0: restitutions never above 1, and a
/// start in its place of the clearance. Another key changes nothing.
Scene scaled(Scene scene, const std::string& key, double factor);

/// Where speeds that keep the limit and speeds that break it divide best [rad/s], between two
/// thirds and three halves of `omega`, to a fiftythousandth; nothing where one kind is all.
std::optional<double> divide_near(const Scene& scene, const Limit& limit, double omega);

struct Sensitivity {
  std::string key;
  double percent;  ///< by which the divide rises, for each percent that the constant does
};

/// By one percent up and down of every constant; the largest first. Leaves out a constant with
/// which there is no divide any more.
std::vector<Sensitivity> sensitivities(const Scene& scene, const Limit& limit, double omega);

/// Divides of machines whose constants are each wrong by up to a tolerance.
struct ToleranceRange {
  double lowest, highest;  ///< [rad/s]
  int machines;            ///< that were drawn
  int without;             ///< of these, without a divide between two thirds and three halves
};

/// Draws machines with every constant times 1 - tolerance .. 1 + tolerance, independent and
/// uniform; tolerance within 0..0.5. The same seed draws the same. Nothing where no machine has a
/// divide.
std::optional<ToleranceRange> tolerance_range(const Scene& scene, const Limit& limit, double omega,
                                              double tolerance, int machines, std::uint64_t seed);

}  // namespace ricochet::carrier_track::inline counting
