#pragma once

#include <filesystem>

#include "src/export/judged_runs.h"
#include "src/export/numbering.h"
#include "src/export/output_file.h"

namespace ricochet::exports {

/// A table for beside an export whose readers compute such figures otherwise: which algorithm and
/// function is what, the share of its runs that solved it, and its expected running time.
class RunningTimes {
 public:
  explicit RunningTimes(const std::filesystem::path& file);
  void add(const JudgedCell& cell, Numbering& numbering);
  void close() { file_.close(); }

 private:
  OutputFile file_;
};

}  // namespace ricochet::exports
