#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ricochet::exports {

struct CocoRow {
  std::int64_t evaluations;
  double optimality_gap, measured;
  std::vector<double> x;  ///< of no number where it is not known
};

struct CocoRun {
  int instance = 0;
  double fopt = 0;
  std::vector<CocoRow> improvements, counts;
};

/// What cocopp would take from three lines of an .info file and the rows they name.
struct CocoCase {
  std::string algorithm;
  int function_id = 0, dimension = 0;
  std::vector<CocoRun> runs;
};

/// Reads the folder of one algorithm as strictly as COCO's post-processing needs it; what breaks a
/// rule is added to `complaints`.
std::vector<CocoCase> read_coco(const std::filesystem::path& root,
                                std::vector<std::string>& complaints);

}  // namespace ricochet::exports
