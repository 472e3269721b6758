#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "src/core/in_parallel.h"

namespace ricochet::carrier_track::inline counting {

/// Fills the counts of a scan in parallel, the slowest speeds first; `counts_at(speeds)` counts a
/// block of neighbouring speeds. Returns how many of the slowest speeds are counted: all of them,
/// unless the time limit is reached.
template <class Scan, class CountsAt>
std::size_t count_in_blocks(Scan& scan, const CountsAt& counts_at) {
  constexpr std::size_t block = 32;
  const std::size_t size = scan.counts.size();
  std::vector<char> counted((size + block - 1) / block, 0);
  try {
    in_parallel("scan of the speeds", counted.size(), [&](std::size_t i) {
      std::vector<double> speeds;
      for (std::size_t k = i * block; k < std::min(size, (i + 1) * block); ++k) {
        speeds.push_back(scan.omega(k));
      }
      const std::vector<int> counts = counts_at(std::span<const double>(speeds));
      std::copy(counts.begin(), counts.end(), &scan.counts[i * block]);
      counted[i] = 1;
    });
  } catch (const TimeLimitReached&) {
    // The blocks before the first that had no time are known.
  }
  const auto first_not = std::find(counted.begin(), counted.end(), 0);
  return std::min(size, static_cast<std::size_t>(first_not - counted.begin()) * block);
}

}  // namespace ricochet::carrier_track::inline counting
