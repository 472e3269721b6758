#pragma once

#include <filesystem>

#include "src/benchmark/analysis/judged_runs.h"
#include "src/benchmark/export/numbering.h"
#include "src/benchmark/export/output_file.h"

namespace ricochet::exports {

/// A table beside an export whose readers compute these numbers differently: the names of
/// algorithms and functions, and, by the best evaluated and by the returned point, the success rate
/// and the expected running time.
class RunningTimes {
 public:
  explicit RunningTimes(const std::filesystem::path& file);
  void add(const comparison::JudgedCell& cell, Numbering& numbering);
  void close() { file_.close(); }

 private:
  OutputFile file_;
};

}  // namespace ricochet::exports
