#pragma once

#include <filesystem>
#include <vector>

#include "src/benchmark/analysis/rated_family.h"

namespace ricochet::exports {

/// Writes ratings.csv, a row for each family and entry, the best first; ecdf.csv, a row for each of
/// them and number of evaluations; and targets.csv, a row for each target of each problem.
void write_ratings(const std::vector<comparison::RatedFamily>& families,
                   const std::filesystem::path& folder);

}  // namespace ricochet::exports
