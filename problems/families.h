#pragma once

#include <vector>

#include "problems/family.h"

namespace ricochet {

/// Every family of problems that there is.
std::vector<Family> all_families();

}  // namespace ricochet
