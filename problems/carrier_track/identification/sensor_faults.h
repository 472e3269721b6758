#pragma once

#include "problems/carrier_track/identification/knock_record.h"

namespace ricochet::carrier_track::inline identification {

/// Finds what a sensor does beside recording each impact once, and says so in the record's notes.
/// Knocks at one time become one, the strongest. Echoes, i.e. knocks that follow others at a fixed
/// delay, with strengths also at a fixed ratio, are removed. Of the record's fields, dead_time is
/// set to the shortest interval that is left, at most 50 ms, and saturation to the largest strength
/// if several knocks have it.
///
/// Rebounds are no echoes: fewer knocks have one of the same delay, and the delay changes with the
/// speed of the plate. Where that does not tell them apart, they stay, and a note says so.
void take_out_sensor_faults(KnockRecord& record);

}  // namespace ricochet::carrier_track::inline identification
