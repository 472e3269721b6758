#pragma once

#include <optional>
#include <vector>

#include "problems/carrier_track/questions/hard_machines.h"

/// The search for machines whose fastest quiet speed is hard to find.
namespace ricochet::studies::best_values {

using carrier_track::HardMachine;
using carrier_track::HardMachines;
using carrier_track::Machine;
using carrier_track::Scene;

/// A random machine around a case of a reading, its window as the case's. Every constant (see
/// constants_of) is that of the reading times 1/2 to 2, log-uniform. The disturbance, which alone
/// has a frequency other than the plate's, is one of 0.1 to 100 N and 1 to 100 rad/s, both
/// log-uniform; its phase and the plate's are uniform. The quiet limit is that of machine_of(scene,
/// ...). The same reading, case and number, the same machine.
Machine random_machine(const Scene& reading, const std::string& around, int draw);

/// What makes a machine hard, where all of these hold; else nothing:
/// - Of the speeds 1e-4, 2e-4, ..., 18 rad/s those of the last pocket are a thousandth to a
///   hundredth of the box, all of them quiet, and no speed beyond is.
/// - The pocket lies half a rad/s or more beyond the end of the first, and a tenth of a rad/s above
///   the next quiet speed.
/// - The best speed, its end to 1e-7 rad/s, is below 17.9 rad/s, and the counts at it and 1e-4
///   rad/s to either side of it are certain.
/// - Bisection ends elsewhere when it begins in the middle of the box or at one of its ends, and
///   from three of four places in between.
/// Scans more coarsely first, so that most machines cost little.
std::optional<HardMachine> judged_hard(const Machine& machine);

/// The `wanted` with the narrowest last pocket, at most five around one case, of `draws` machines
/// around each case of the default reading. The narrowest is "01".
HardMachines find_hard_machines(int draws, std::size_t wanted);

}  // namespace ricochet::studies::best_values
