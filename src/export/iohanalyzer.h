#pragma once

#include <filesystem>

#include "src/store/store.h"

namespace ricochet::exports {

/// For IOHanalyzer (Wang et al. 2022, doi:10.1145/3510426): a folder for each algorithm, whose name
/// it is, with a JSON file for each question and its rows of figures beside; and README.txt, which
/// says what is in them, and running_times.csv, with expected running times of our own. raw_y is
/// the regret. See Numbering for what is an algorithm, best_so_far for the rows.
void write_iohanalyzer(const Store& store, const std::filesystem::path& folder);

}  // namespace ricochet::exports
