#pragma once

#include <filesystem>
#include <vector>

#include "src/analysis/export/ioh_and_coco.h"
#include "src/analysis/export/output.h"
#include "src/analysis/outcomes.h"
#include "src/analysis/rating.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/store.h"

namespace ricochet::exports {

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
