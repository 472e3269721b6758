#pragma once

#include <string>

#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline scene {

/// Throws InputError, with one line "<origin>: <table.key> = <value>: must be <allowed range>", for
/// the first invalid field of `scene`. `origin` names the scene, for instance its file.
void check(const Scene& scene, const std::string& origin);

/// The same for a speed of the driver plate [rad/s] that did not come from a file.
void check_omega(const Scene& scene, const std::string& origin, const std::string& name);

}  // namespace ricochet::carrier_track::inline scene
