#pragma once

#include <cstdint>
#include <string_view>

namespace ricochet {

/// A seed that depends on the identity of a run, not on when or where it executes: a 64-bit FNV-1a
/// hash of the names and numbers, each closed by a separator. `shown`, unless empty, distinguishes
/// the formulations of the same problem.
std::uint64_t seed_of(std::string_view problem, std::string_view solver, int instance, int run,
                      std::string_view shown = {});

}  // namespace ricochet
