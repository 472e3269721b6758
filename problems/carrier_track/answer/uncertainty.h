#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/answer/sensitivity.h"
#include "problems/carrier_track/counting/limit.h"
#include "problems/carrier_track/scene/scene_file.h"

namespace ricochet::carrier_track::inline answer {

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

}  // namespace ricochet::carrier_track::inline answer
