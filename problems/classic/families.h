#pragma once

#include <vector>

#include "problems/family.h"

namespace ricochet::classic {

/// Test functions, constrained test problems, and least squares.
std::vector<Family> families();

}  // namespace ricochet::classic
