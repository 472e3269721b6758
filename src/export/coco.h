#pragma once

#include <filesystem>

#include "src/store/store.h"

namespace ricochet::exports {

/// For the post-processing of COCO (Hansen et al. 2021, doi:10.1080/10556788.2020.1808977): a
/// folder for each algorithm, as its suite bbob-mixint leaves one, of all questions; and
/// README.txt, which says what of it can be opened, and running_times.csv, with expected running
/// times of our own. See Numbering for what is an algorithm, best_so_far for the rows.
void write_coco(const Store& store, const std::filesystem::path& folder);

}  // namespace ricochet::exports
