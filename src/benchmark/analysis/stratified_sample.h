#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ricochet::comparison {

/// Draws `number` of these items, one from each of as many strata of equal size (up to one item):
/// the items sorted by their value, equal ones in the given order. In ascending order of the value.
/// All if there are no more. Deterministic in `seed`. Returns indices.
std::vector<std::size_t> stratified_sample(const std::vector<double>& values, std::size_t number,
                                           std::uint64_t seed);

}  // namespace ricochet::comparison
