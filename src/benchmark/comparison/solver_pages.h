#pragma once

#include <vector>

#include "src/benchmark/comparison/entry_set.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// A row of version, note and names for each library of these solvers of which a reader must know
/// something; see library_note.
report::Json library_notes(const std::vector<Solver>& solvers);

/// Returns the data of the page of all solvers, by name: families and problems that each takes,
/// solved (number of these problems that it solved in at least one run, by the returned point),
/// fronts (the families on whose Pareto front of speed and accuracy it is). Under `pages` is a page
/// for each. `speed_accuracy` are the rows of speed_accuracy_data(). All is of the largest budgets
/// and the solver's best formulation for a family, except for the termination reasons, which are
/// of all runs.
report::Json solvers_page(const Campaign& campaign, const std::vector<CellResult>& results,
                          const std::vector<EntrySet>& sets, const report::Json& speed_accuracy);

}  // namespace ricochet::studies::comparison
