#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "src/analysis/comparison/group.h"
#include "src/report/table.h"

namespace ricochet::studies::comparison {

/// Expected running time of random search on the true values of a problem, with the largest budget
/// [evaluations]; infinite if no run solved it, nothing if it was not run there.
std::optional<double> random_search_time(const Comparison& comparison, std::size_t problem);

/// The runs of a problem with the largest budget, by the returned points.
struct Tries {
  std::size_t entries = 0, runs = 0;
  std::size_t solved = 0;   ///< runs
  std::size_t solving = 0;  ///< entries that solve it in at least half of their runs
  double gap = std::numeric_limits<double>::infinity();  ///< the least
};
Tries tries_on(const Comparison& comparison, std::size_t problem);

/// Sets the problems of each part that tell nothing about solvers with the largest budget: those
/// that random search solves within 20 evaluations, wherever 5 % of the box solve a problem, and
/// those that no run solved. They are left out of rankings and rates, unless all problems of their
/// family in this part are such.
void set_silent(const Campaign& campaign, const std::vector<CellResult>& results,
                std::vector<ReportedPart>& parts);

/// These problems: family (as the report names it), problem, variables, entries, runs, unsolved,
/// random (evaluations of random search), gap (the least of any run, in tolerances). `left_out`:
/// they are not ranked, since other problems of their family are.
Table silent_table(const Campaign& campaign, const std::vector<CellResult>& results,
                   const std::vector<ReportedPart>& parts);

/// A row for each family with each budget. `first` is who is first by mean rank, by the rule that
/// holds everywhere: the entry with the least mean rank by the returned points; none if it solved
/// none of its runs; none named if random search solves the problems within 20 evaluations (median
/// of its expected running times, `random`). `most` is the entry that solves most runs, with its
/// success rate, if that solves more than the first. Further columns: budget, largest, solver,
/// formulation, tuned (see tuned_mark()), returned (success rate), best (P(best)), takes, problems,
/// clusters, ranked, entries, unsolved (problems that no entry solved in any run), left_out (see
/// set_silent(); they are not among the problems); and the first
/// where a gradient costs n evaluations, as by differences, if both prices were run:
/// differences_first, differences_returned, differences_best.
Table leader_table(const std::vector<RatedPart>& parts);

/// Who is first on parts of a family, with the largest budget: for each number of variables (or
/// range of them), with and without constraints, and for each distance of the published start. A
/// division is there if a part of it has another first solver than the family, at one of the two
/// prices. Columns: family, subset ("8 variables"), and as in leader_table() problems, clusters,
/// first, tuned, returned, best, differences_first, differences_returned, differences_best.
Table subset_table(const std::vector<RatedPart>& parts);

/// How far the problems of a family are alike, with the largest budget: family, problems, clusters,
/// effective (problems, see effective_problems()), coverage of the intervals of success rates,
/// nominally 95 %, over clusters, and `ignoring`, if they were over problems.
Table coverage_table(const std::vector<RatedPart>& parts);

}  // namespace ricochet::studies::comparison
