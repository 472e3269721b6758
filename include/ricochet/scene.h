#pragma once

/// @file
/// A machine, and the TOML file that describes it.

#include "problems/carrier_track/scene/scene.h"
#include "problems/carrier_track/scene/scene_file.h"
