#pragma once

#include <optional>
#include <vector>

#include "problems/carrier_track/suite/hard_machines.h"

/// The search for machines whose fastest quiet speed is hard to find.
namespace ricochet::studies::best_values {

using carrier_track::HardMachine;
using carrier_track::HardMachines;
using carrier_track::Machine;
using carrier_track::Scene;

/// Returns a random machine around a case of an interpretation, with the case's window. Every
/// parameter (see constants_of) is that of the interpretation times 1/2 to 2, log-uniform. The
/// disturbance, the only force whose frequency differs from the plate's, has 0.1 to 100 N and 1 to
/// 100 rad/s, both log-uniform; its phase and the plate's are uniform. The quiet limit is that of
/// machine_of(scene, ...). The result depends only on interpretation, case and number.
Machine random_machine(const Scene& interpretation, const std::string& around, int draw);

/// Returns how hard a machine is if all of these hold, else nothing:
/// - Of the speeds 1e-4, 2e-4, ..., 18 rad/s those of the last quiet interval are 0.1 % to 1 % of
///   the box, all of them quiet, and no speed beyond is quiet.
/// - The quiet interval lies at least 0.5 rad/s beyond the end of the first, and 0.1 rad/s above
///   the next quiet speed.
/// - The best speed, its end to 1e-7 rad/s, is below 17.9 rad/s, and the counts at it and 1e-4
///   rad/s to either side of it are certain.
/// - Bisection ends elsewhere if started in the middle of the box, at one of its ends, or from
///   three quarters of the places in between.
/// Scans more coarsely first, so that most machines are cheap.
std::optional<HardMachine> judged_hard(const Machine& machine);

/// Of `draws` machines around each case of the default interpretation, returns the `wanted` ones
/// with the narrowest last quiet intervals, at most five around one case. The narrowest is "01".
HardMachines find_hard_machines(int draws, std::size_t wanted);

}  // namespace ricochet::studies::best_values
