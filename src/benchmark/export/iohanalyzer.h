#pragma once

#include <filesystem>

#include "src/benchmark/experiment/campaign/completeness.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet::exports {

/// Writes the format of IOHanalyzer (Wang et al. 2022, doi:10.1145/3510426): a folder for each
/// algorithm, with its name, which holds a JSON file for each problem and the rows of data beside
/// it; README.txt, which explains them; and running_times.csv, with expected running times computed
/// by ricochet. raw_y is the optimality gap. See Numbering for the algorithms, best_so_far for the
/// rows.
void write_iohanalyzer(const Store& store, const Completeness& completeness,
                       const std::filesystem::path& folder);

}  // namespace ricochet::exports
