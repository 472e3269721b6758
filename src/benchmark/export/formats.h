#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/benchmark/analysis/rated_family.h"
#include "src/benchmark/experiment/campaign/completeness.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet::exports {

/// A format for exporting the content of a store to other tools.
struct Format {
  std::string name;
  std::string about;  ///< one line
  /// Writes files into the folder, which must exist and be empty; they say how complete the runs
  /// are. Throws InputError if the store is damaged, OutputError if the disk is full.
  std::function<void(const Store&, const Completeness&, const std::filesystem::path& folder)> write;
  /// Adds files about the ranked entries of a store whose runs are complete; empty if there are
  /// none.
  std::function<void(const std::vector<comparison::RatedFamily>&,
                     const std::filesystem::path& folder)>
      write_rated = {};
};

std::vector<Format> all_formats();

}  // namespace ricochet::exports
