#pragma once

#include <vector>

namespace ricochet {

/// The rank of every value in the sorted sample, from 1 on; equal values share their mean rank.
/// Infinite values are allowed. Throws std::invalid_argument for a value that is no number.
std::vector<double> ranks_of(const std::vector<double>& sample);

}  // namespace ricochet
