#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "src/report/json.h"

namespace ricochet::studies {

/// A study: a folder of src/studies, a command, and a report that is drawn from its results.
struct Study {
  std::string name;   ///< of its folder, of its report and of the report's template
  std::string quick;  ///< what --quick does; empty where there is no such thing
  /// Computes the results: what the template asks for. Shows its progress. The same every time, but
  /// for measured times.
  std::function<report::Json(bool quick)> compute;
};

/// What came of a study.
struct Finished {
  report::Json data;     ///< the results, as in the report's data.json
  std::string epilogue;  ///< lines for who called, with where the report is
};

/// Computes a study and writes its report into the folder. To the results it adds `report`, the
/// study's name, and `made`: version, compiler, threads, seconds (elapsed), date (UTC), quick.
/// Writes the front page above the folder too, where there is to be one, see site.h. Throws
/// InputError, before any work, where the folder cannot be written.
Finished run(const Study& study, bool quick, const std::filesystem::path& folder);

}  // namespace ricochet::studies
