#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "ricochet/problem.h"

namespace ricochet::studies::best_values {

/// Takes the points of a store's runs that are better than the best values known by more than the
/// problem's tolerance, as reports have it, and writes all values to a file of best_known.h.
/// Returns the number of problems whose value is better than before. Every point is evaluated
/// again, in the problem as stated; the file stays unchanged if none is better. Throws InputError
/// if the store or the file cannot be read.
std::size_t take_stored_values(const std::vector<Problem>& problems,
                               const std::filesystem::path& store,
                               const std::filesystem::path& file);

}  // namespace ricochet::studies::best_values
