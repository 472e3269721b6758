#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ricochet::exports {

struct ReadRow {
  std::int64_t evaluations;
  double raw_y, seconds, gevals;
};

struct ReadRun {
  int instance = 0;
  std::vector<ReadRow> rows;
};

/// What IOHanalyzer would take from one JSON file and the rows it names.
struct ReadCase {
  std::string algorithm, function;
  int function_id = 0, dimension = 0;
  std::vector<ReadRun> runs;
};

/// Reads the folder of one algorithm as strictly as IOHanalyzer needs it: see the rules in the
/// source, each of which its reader has or would silently get wrong. What breaks one is added to
/// `complaints`.
std::vector<ReadCase> read_iohanalyzer(const std::filesystem::path& root,
                                       std::vector<std::string>& complaints);

}  // namespace ricochet::exports
