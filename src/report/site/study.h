#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/report/json.h"

namespace ricochet::studies {

/// A study: a folder of src/studies, a command, and a report from its results.
struct Study {
  std::string name;   ///< of its folder, of its report and of the report's template
  std::string quick;  ///< effect of --quick; empty if there is none
  /// Computes the data for the template and shows progress. Results are reproducible, except for
  /// measured times.
  std::function<report::Json(bool quick)> compute;
};

/// The result of a study.
struct Finished {
  report::Json data;     ///< the results, as in the report's data.json
  std::string epilogue;  ///< closing lines for the user, with the time and the report's folder
  std::vector<std::string> failures;  ///< a line for each chart that could not be drawn
};

/// Computes a study and writes its report into the folder. Adds to the results `report`, the
/// study's name, and `made`: version, compiler, threads, seconds (elapsed since `start`, without
/// the drawing), date (UTC), quick. Also writes the front page above the folder if that is a site,
/// see site.h. The epilogue says how long all took since `start`. Throws InputError, before any
/// work, if the folder cannot be written.
[[nodiscard]] Finished run(
    const Study& study, bool quick, const std::filesystem::path& folder,
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now());

}  // namespace ricochet::studies
