#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "src/benchmark/statistics/interval.h"
#include "src/benchmark/statistics/rivals_ahead.h"

namespace ricochet {

/// How well the order of the entries on half of the problems predicts that on the other half.
struct HeldOutOrder {
  double correlation;  ///< Kendall's tau of the two orders, mean over the halves
  Interval interval;   ///< the middle 95 % of the halves
  double first_stays;  ///< how often the first on one half is first on the other, in [0, 1]
};

/// Draws `halves` random halves of the problems; of an odd number one problem is left out each
/// time. The order is that of the mean shares of rivals ahead, over the entries that took part in
/// both halves. Firsts that are tied are drawn from. Deterministic in `seed`. Nothing for fewer
/// than four problems or five entries, or if all entries are tied. The halves share problems, so
/// the interval is no confidence interval: it says how much depends on which problems were taken.
std::optional<HeldOutOrder> held_out_order(const std::vector<RivalsAhead>& problems,
                                           std::size_t entries, std::uint64_t seed,
                                           int halves = 500);

}  // namespace ricochet
