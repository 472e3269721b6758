#pragma once

#include <string>
#include <vector>

#include "ricochet/families.h"

namespace ricochet {

/// Every family of problems of the suite: those of problems/families.h and the calibration of the
/// paper's default interpretation. With a scene file, the families of its machine instead; throws
/// InputError if the file is invalid.
std::vector<Family> suite_families(const std::string& scene_file = "");

}  // namespace ricochet
