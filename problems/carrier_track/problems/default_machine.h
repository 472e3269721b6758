#pragma once

#include <string>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline problems {

/// The machine of every case except for restitution, friction and disturbance:
/// default_machine.toml.
const Scene& default_machine();

/// Sixteen hexadecimal digits that change with any constant of the default machine. Best values are
/// stored with this hash and hold for this machine only.
const std::string& default_machine_hash();

}  // namespace ricochet::carrier_track::inline problems
