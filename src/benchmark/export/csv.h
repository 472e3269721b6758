#pragma once

#include <filesystem>

#include "src/benchmark/experiment/campaign/completeness.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet::exports {

/// Writes runs.csv, improvements.csv, points.csv, problems.csv, running_times.csv and a README.txt
/// that explains their columns and those of write_ratings(). Numbers read back to the same bits;
/// missing values are empty, and no text is read as one: see label(). Control characters in texts
/// are written as \x0a, and the middle of texts beyond 4000 bytes is left out.
void write_csv(const Store& store, const Completeness& completeness,
               const std::filesystem::path& folder);

}  // namespace ricochet::exports
