#pragma once

#include <vector>

#include "ricochet/families.h"

namespace ricochet::classic {

/// Test functions, constrained test problems, and least squares.
std::vector<Family> families();

}  // namespace ricochet::classic
