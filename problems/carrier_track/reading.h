#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/scene.h"

namespace ricochet::carrier_track {

/// One way to read what the paper leaves open, with constants for what it does not give.
struct Reading {
  std::string name;
  std::string description;
  Scene scene;  ///< its constants; restitution, friction and disturbance belong to a case
};

std::vector<Reading> all_readings();

/// The reading that every command uses.
Reading default_reading();

}  // namespace ricochet::carrier_track
