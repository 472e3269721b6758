#pragma once

#include <limits>

namespace ricochet {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace ricochet
