#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "src/benchmark/statistics/ranking.h"

namespace ricochet {

/// The entries that took part in one problem. For each of its instances and each of these entries:
/// the share of its rivals that were ahead of it, in [0, 1], where a tie counts half. It is the
/// rank, scaled so that problems with many and with few entries compare.
struct RivalsAhead {
  std::vector<std::size_t> entries;
  std::vector<std::vector<double>> of_instance;  ///< instances x entries
};

/// From the rankings of a problem's instances, at least one, which must name the same entries.
/// Empty if fewer than two took part: then nobody is compared. Throws std::invalid_argument for
/// rankings of different entries.
RivalsAhead rivals_ahead(const std::vector<Ranking>& instances);

/// The mean over instances, then over problems, for each of the entries 0, 1, ..., rounded to
/// 1e-12; nothing for one that took part in no problem.
std::vector<std::optional<double>> mean_rivals_ahead(const std::vector<RivalsAhead>& problems,
                                                     std::size_t entries);

/// The entries whose mean is the least: several if they are tied, none if none has a mean.
std::vector<std::size_t> first_of(const std::vector<std::optional<double>>& means);

}  // namespace ricochet
