#pragma once

#include <string>
#include <vector>

#include "problems/family.h"

namespace ricochet::cli {

/// Every family, or, where a scene file is named, those of that machine. Throws InputError for a
/// bad file.
std::vector<Family> choose_families(const std::string& scene_file);

}  // namespace ricochet::cli
