#pragma once

#include <vector>

namespace ricochet {

/// The place of every value in the sorted sample, from 1 on; equal values share the mean of theirs.
/// Infinite values are allowed. Throws std::invalid_argument for a value that is no number.
std::vector<double> ranks_of(const std::vector<double>& sample);

}  // namespace ricochet
