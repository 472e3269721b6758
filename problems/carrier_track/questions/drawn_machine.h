#pragma once

#include "problems/carrier_track/questions/machine.h"

namespace ricochet::carrier_track::inline questions {

/// How far a constant of a drawn machine is at most from that of the machine it is drawn around.
inline constexpr double drawn_tolerance = 0.05;

/// Another machine of the same kind: every constant (see constants_of) times 0.95 to 1.05,
/// independent and uniform; a restitution is never above 1. Quiet limit and threshold are kept, and
/// no reading is: best values of the one are not those of the other, see with_scanned_best.
/// Deterministic in id and number; "C1~3" is number 3 around C1, and number 0 the machine itself.
/// Throws std::invalid_argument for number < 0.
Machine drawn_machine(Machine machine, int number);

}  // namespace ricochet::carrier_track::inline questions
