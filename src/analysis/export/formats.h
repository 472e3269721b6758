#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/analysis/rating.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/store.h"
#include "src/report/json.h"

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

/// Writes runs.csv, improvements.csv, points.csv, problems.csv, running_times.csv and a README.txt
/// that explains their columns and those of write_ratings(). Numbers read back to the same bits;
/// missing values are empty, and no text is read as one: see label(). Control characters in texts
/// are written as \x0a, and the middle of texts beyond 4000 bytes is left out.
void write_csv(const Store& store, const Completeness& completeness,
               const std::filesystem::path& folder);

/// The numbers of planned, present and missing runs, of all and by part, and of what runs are
/// missing.
report::Json json_of(const Completeness& completeness);

/// Writes campaign.json, the description of the campaign; runs.jsonl, one object on a line for each
/// run, with its key, budget, ledger, verdict and improvements; and README.txt. Numbers that JSON
/// cannot write are null.
void write_json(const Store& store, const Completeness& completeness,
                const std::filesystem::path& folder);

}  // namespace ricochet::exports
