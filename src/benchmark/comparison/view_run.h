#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/benchmark/analysis/outcome.h"
#include "src/benchmark/analysis/targets.h"

namespace ricochet::studies::comparison {

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
