#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problems/own/own_problem.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/analysis/comparison/reported_part.h"

/// Solvers compared on problem files. No best value is known there: the reference is the best that
/// any of them found.
namespace ricochet::cli {

struct OwnComparisonOptions {
  /// Files, as its problems; its smoothings, instances and scene are not used. Of its formulations
  /// "*" is for each solver the first that it accepts.
  studies::ComparisonOptions compared;
  int starts = 5;
  std::optional<std::int64_t> evaluations = {};  ///< of all runs together
  std::optional<double> seconds = {};            ///< wall time of all runs together
  int workers = 0;                               ///< runs at once; 0: as many as cores
  bool allow_programs = false;
  std::string out = {};  ///< folder; empty: reports/ and the problem's name
  bool json = false;
};

/// What has a rank: a solver that sees the problem in a formulation.
struct OwnEntry {
  Solver solver;
  Formulation formulation;
  std::string formulation_name;
};

struct OwnRun {
  RunRecord record;
  own::EvaluationCounts counts;

  /// The best evaluated point, or null; it may not be feasible.
  const Improvement* best() const { return record.trace.empty() ? nullptr : &record.trace.back(); }
};

/// Runs on one problem. All entries have runs from the same starts, with the same budget.
struct OwnRuns {
  own::OwnProblem own;
  std::vector<OwnEntry> entries = {};
  std::int64_t budget = 0;  ///< [evaluations] of each run
  int rounds = 0;           ///< that were planned: starts
  /// A row for each start, that of the file first, and a column for each entry.
  std::vector<std::vector<OwnRun>> runs = {};
  own::EvaluationCounts counts = {};
};

/// Makes the runs of one file; all of the files share what the options allow. Throws InputError for
/// options out of their range, and where no solver accepts the problem.
OwnRuns own_runs(const OwnComparisonOptions& options, const std::string& file);

/// Compares solvers on each file, prints the answers, and writes the reports. Returns the exit
/// code.
int compare_on_files(const OwnComparisonOptions& options);

}  // namespace ricochet::cli
