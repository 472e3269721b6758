#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ricochet/solver.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/outcomes.h"
#include "src/analysis/statistics/ranking.h"
#include "src/report/results.h"

namespace ricochet::studies::comparison {

/// The page on which a reader filters the runs: tables whose names begin with "view-", a compact
/// form of all runs.
///
/// The tables are lists of names, which "view-entries" counts from 0: families (of problems, as the
/// report names them), problems, solvers, formulations, perturbations and prices of a gradient. An
/// entry is a solver-formulation pair on one family under one perturbation, price and budget
/// (evaluations for each variable). Its column `problems` has a 1 for each problem of the family
/// that it takes and a 0 for others, or is empty if it takes all; `shared` has a 1 for each that it
/// takes whose runs are stored at the price n, since they are the same there, or is empty. Its runs
/// are in the order of the problems, then of the instances, then of the seeds; how they are written
/// is below. "view-orders" has a text for each family, perturbation, price and budget, in the order
/// of the entries: how the runs that miss targets are ranked. A family's `joint` is the budget with
/// which it is among "all", see joint_entry_set(); its `problems` are numbers of problems, of which
/// those that are `silent` count in no rate (see ReportedPart). A run is in the part of the plan
/// that asks for it first. `known`: the solvers of the suite.
report::Results view_page(const Campaign& campaign, const std::vector<CellResult>& results,
                          const std::vector<ReportedPart>& parts, const std::vector<EntrySet>& sets,
                          const std::vector<Solver>& known);

/// Runs that are ranked with each other: problem, number of the run in its cell, and targets that
/// the returned point misses. Between two targets the gaps differ, and the view has no gaps.
using RankedTogether = std::tuple<std::size_t, std::size_t, std::int64_t>;

/// The order of runs by what they reached, as text, for ranks that are those of the gaps
/// themselves. A run is written as its position among those before it that are ranked with it: 2 i
/// + 1 if it is equal to the i-th best of their k different values, 2 i if it comes just before
/// that one, 2 k after all. That is a number below 2 k + 1, in as many bits as the largest needs,
/// the lowest first; none for the first run. Six bits are a digit of base64.
class ViewOrderWriter {
 public:
  void add(const RankedTogether& together, const Reached& reached);

  /// Of the runs so far.
  std::string text() const;

 private:
  using Value = std::pair<double, double>;

  std::map<RankedTogether, std::vector<Value>> values_;  ///< different ones, the best first
  std::vector<bool> bits_;
};

/// A digit of base64, of a value in [0, 63].
char view_digit(std::int64_t value);

/// What the reader's own view of a comparison needs of a run.
struct ViewRun {
  /// Targets that the returned point does not reach, 0 if it solves the problem; one more than
  /// there are without a feasible point.
  std::int64_t missing = 0;
  /// Evaluations until each of the view's levels was reached, easiest first; of the first levels
  /// only, if the returned point does not reach the others. They do not fall.
  std::vector<std::int64_t> times;
  std::int64_t evaluations = 0;  ///< charged in all
  bool repeats = false;          ///< an earlier run of its cell: see repeats()
};

/// The levels of the view: thirds of a problem's targets, from the easiest on. A level is reached
/// with at least that share of them; the last one is to solve the problem.
inline constexpr int view_levels = 3;

/// Number of targets, of this many, that level 0, 1 or 2 takes.
std::int64_t targets_at(int level, std::size_t targets);

ViewRun view_run(const ricochet::comparison::Outcome& outcome,
                 const ricochet::comparison::Targets& targets);

/// Runs as text, a few characters each. Numbers >= 0 are in the digits of base64, five bits each,
/// the lowest first; a sixth bit says that more follow (as in source maps).
struct ViewRunsText {
  /// Of each run a digit, the targets that are missing; 63 or more are the digit 63 and a number.
  std::string missing;
  /// Of each run the evaluations until each level that it reached, as numbers: the first, then what
  /// each next one takes more.
  std::string times;
  /// Of the runs that did not solve the problem, those that were not charged their whole budget:
  /// how many before it were, and the evaluations that were left, twice; of those charged more, the
  /// evaluations beyond, twice, less 1.
  std::string spent;
  /// Of the runs that repeat an earlier one, how many before it do not, since the last one.
  std::string repeats;
};

/// Collects the runs of an entry.
class ViewRunsWriter {
 public:
  /// `budget`: evaluations that the run had.
  void add(const ViewRun& run, std::int64_t budget);

  const ViewRunsText& text() const { return text_; }

 private:
  ViewRunsText text_;
  std::int64_t whole_ = 0;   ///< runs since the last one in `spent`
  std::int64_t single_ = 0;  ///< runs since the last one in `repeats`
};

}  // namespace ricochet::studies::comparison
