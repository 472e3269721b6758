#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "src/benchmark/statistics/rivals_ahead.h"

namespace ricochet {

/// The probability of each of the entries 0, 1, ... to be first on problems like these: the share
/// of bootstrap samples in which it has the least mean share of rivals ahead (Efron 1979,
/// doi:10.1214/aos/1176344552). A sample draws as many problems as there are, with replacement, and
/// for each of them as many of its instances, with replacement: runs on one problem are alike, so
/// more instances of a few problems do not make the result certain. Entries that are tied share a
/// sample; one that took part in none of its problems is not in it. Deterministic in `seed`; with
/// another one, probabilities differ by about 0.02. Throws std::invalid_argument for fewer than two
/// problems, of which nothing can be drawn.
std::vector<double> probabilities_of_being_first(const std::vector<RivalsAhead>& problems,
                                                 std::size_t entries, std::uint64_t seed,
                                                 int resamples = 2000);

}  // namespace ricochet
