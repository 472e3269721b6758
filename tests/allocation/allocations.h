#pragma once

#include <cstdint>

namespace ricochet {

/// Calls of operator new, in all its formulations, since this program began. A program that links
/// allocations.cpp has its global operators new and delete replaced by counting ones.
std::int64_t allocations();

}  // namespace ricochet
