#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "src/analysis/export/output.h"
#include "src/analysis/outcomes.h"
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

/// Writes table.tex, a longtable with a row for each problem and entry; a comment in it lists the
/// LaTeX packages it needs.
void write_latex(const Store& store, const Completeness& completeness,
                 const std::filesystem::path& folder);

/// Writes summary.tex, a table that fits a page: the first ranked entries of each family, as many
/// of each as 45 rows allow, but at least one, and none that solved no run. Names that are too long
/// for the page make the table smaller. A comment lists the LaTeX packages it needs.
void write_latex_summary(const std::vector<comparison::RatedFamily>& families,
                         const std::filesystem::path& folder);

/// Writes table.md, a table with a row for each problem and entry.
void write_markdown(const Store& store, const Completeness& completeness,
                    const std::filesystem::path& folder);

/// Writes ratings.csv, a row for each family and entry, the best first; ecdf.csv, a row for each of
/// them and number of evaluations; and targets.csv, a row for each target of each problem.
void write_ratings(const std::vector<comparison::RatedFamily>& families,
                   const std::filesystem::path& folder);

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

/// A table beside an export whose readers compute these numbers differently: the names of
/// algorithms and functions, and, by the best evaluated and by the returned point, the success rate
/// and the expected running time.
class RunningTimes {
 public:
  explicit RunningTimes(const std::filesystem::path& file);
  void add(const comparison::JudgedCell& cell, Numbering& numbering);
  void close() { file_.close(); }

 private:
  TableFile file_;
};

}  // namespace ricochet::exports
