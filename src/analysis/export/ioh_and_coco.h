#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "src/analysis/outcomes.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/store.h"

namespace ricochet::exports {

/// Writes the format of COCO's post-processing (Hansen et al. 2021,
/// doi:10.1080/10556788.2020.1808977): a folder for each algorithm, with all problems, as written
/// by COCO's suite bbob-mixint; README.txt, which says what of it can be opened; and
/// running_times.csv, with expected running times computed by ricochet. See Numbering for the
/// algorithms, best_so_far for the rows.
void write_coco(const Store& store, const Completeness& completeness,
                const std::filesystem::path& folder);

/// Writes the format of IOHanalyzer (Wang et al. 2022, doi:10.1145/3510426): a folder for each
/// algorithm, with its name, which holds a JSON file for each problem and the rows of data beside
/// it; README.txt, which explains them; and running_times.csv, with expected running times computed
/// by ricochet. raw_y is the optimality gap. See Numbering for the algorithms, best_so_far for the
/// rows.
void write_iohanalyzer(const Store& store, const Completeness& completeness,
                       const std::filesystem::path& folder);

/// Stands for the optimality gap until a feasible point is found, in formats that require a number.
/// An optimality gap of this size or more is left out as if not found.
inline constexpr double nothing_feasible = 1e30;

/// The best optimality gap of a run over its evaluations, as readers of other suites expect it: the
/// first row is of evaluation 1, the last of the run's last evaluation; evaluations rise; every
/// optimality gap except the last row's is below the one before; all are finite. A run that was
/// charged nothing has one row, of evaluation 1. Seconds are 0 if unknown.
std::vector<comparison::Step> best_so_far(const comparison::Outcome& outcome);

/// What readers of other suites need instead of names: numbers of functions, and names that are
/// valid as file names and in lists. The names hold only letters, digits and -._+, have at most 100
/// characters, and are different for different things.
class Numbering {
 public:
  explicit Numbering(const CampaignDescription& description);

  /// 1, 2, ... Problems with 5 or 6 variables come first, because COCO opens only those, and only
  /// 24; the others follow in the order of the description.
  int function_id(const std::string& problem) const { return functions_.at(problem).id; }
  const std::string& function_name(const std::string& problem) const {
    return functions_.at(problem).name;
  }

  /// The name of the cell's algorithm. An algorithm is everything of a cell except its problem:
  /// solver, formulation, perturbation, gradient price and budget (runs with another budget are
  /// other runs).
  const std::string& algorithm(const Cell& cell);

 private:
  struct Function {
    int id;
    std::string name;
  };
  std::map<std::string, Function> functions_;
  std::map<Cell, std::string> algorithms_;  ///< of cells without their problem
  std::set<std::string> taken_;
};

}  // namespace ricochet::exports
