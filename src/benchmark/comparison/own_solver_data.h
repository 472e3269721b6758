#pragma once

#include <vector>

#include "ricochet/solver.h"
#include "src/benchmark/comparison/entry_set.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// How the user's solvers did beside the others: `own_solvers`, a row for each of them and each
/// family with its largest budget, with the success rate of its entry, its interval, the number of
/// other solvers that solve fewer and more of the problems that both take (if these are at least
/// half of the family's), and on how many of these the difference is significant: Wilcoxon's
/// signed-rank test over problems, with Holm's correction over the solvers of the family, at 5 %.
/// `own_totals`, a row for each: the problems that it solved in most of its runs.
report::Json own_solver_data(const Campaign& campaign, const std::vector<EntrySet>& sets,
                             const std::vector<Solver>& suite);

}  // namespace ricochet::studies::comparison
