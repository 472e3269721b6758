#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace ricochet::carrier_track::inline counting {

/// Fills the counts of a scan in parallel; `counts_at(speeds)` counts a block of neighbouring
/// speeds.
template <class Scan, class CountsAt>
void count_in_blocks(Scan& scan, const CountsAt& counts_at) {
  constexpr std::size_t block = 32;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, scan.counts.size(), block),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      std::vector<double> speeds;
                      for (auto k = range.begin(); k != range.end(); ++k) {
                        speeds.push_back(scan.omega(k));
                      }
                      const std::vector<int> counts = counts_at(std::span<const double>(speeds));
                      std::copy(counts.begin(), counts.end(), &scan.counts[range.begin()]);
                    });
}

}  // namespace ricochet::carrier_track::inline counting
