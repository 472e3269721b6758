#pragma once

#include <filesystem>

#include "src/benchmark/experiment/campaign/completeness.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet::exports {

/// Writes the format of COCO's post-processing (Hansen et al. 2021,
/// doi:10.1080/10556788.2020.1808977): a folder for each algorithm, with all problems, as written
/// by COCO's suite bbob-mixint; README.txt, which says what of it can be opened; and
/// running_times.csv, with expected running times computed by ricochet. See Numbering for the
/// algorithms, best_so_far for the rows.
void write_coco(const Store& store, const Completeness& completeness,
                const std::filesystem::path& folder);

}  // namespace ricochet::exports
