#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/comparison/reported_part.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// For every family that is posed on a grid of machines, maps over their factors, all of one shape:
/// in `machines` the best known values, in `machine_maps` the share solved by each of its best
/// entries. The first factor has a column for each level, the others a row for each combination.
/// `landscapes` has the true objective of problems of one variable without constraints, e.g. the
/// collisions over the speed, a row for each machine.
report::Json machine_data(const Campaign& campaign, const std::vector<CellResult>& results,
                          const std::vector<ReportedPart>& parts);

/// The result of an entry on one problem, mean over its runs.
struct MachineResult {
  const Problem* problem;
  double solved = 0;    ///< share
  double cost = 0;      ///< log10 of the evaluations until solved, or of all
  double accuracy = 0;  ///< share of the problem's targets reached
};

/// The results of entries, by solver and formulation, on the problems of a family.
using ByEntry = std::map<std::pair<std::string, std::string>, std::vector<MachineResult>>;

/// Returns, by family, the results of each entry on those problems of a part that vary the machine.
std::map<std::string, ByEntry> machine_results(const Campaign& campaign,
                                               const std::vector<CellResult>& results,
                                               const ReportedPart& part);

/// Returns the factors of a family's machines that have several levels, with their levels. It is
/// empty if there are no more machines than such factors: their effects could not be separated.
std::map<std::string, std::vector<double>> factors_of(const ByEntry& entries);

double mean_solved(const std::vector<MachineResult>& results);

/// The entries of a family, most solved first.
std::vector<const ByEntry::value_type*> best_first(const ByEntry& entries);

std::string name_of(const ByEntry::value_type& entry);

/// Returns the name of a factor's level: a number, or the name of a fidelity.
std::string level_name(const std::string& factor, double level);

}  // namespace ricochet::studies::comparison
