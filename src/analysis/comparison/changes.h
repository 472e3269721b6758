#pragma once

#include <string>
#include <vector>

#include "src/analysis/comparison/reported_part.h"
#include "src/experiment/store.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// For each part and family: which entry is first, with the largest budget and without
/// perturbations, and how well the order of the entries agrees with that of the first setting:
/// - for each price of a gradient, if a part has several;
/// - for the surrogate of each smoothing parameter, the default one first;
/// - on the machines of each level of a factor that varies from machine to machine, such as the
///   fidelity of the simulation, the lowest level first.
report::Json change_data(const Campaign& campaign, const std::vector<CellResult>& results,
                         const std::vector<ReportedPart>& parts);

/// How the cost of an entry changed from one store to another, over the problems that both have.
/// The cost on a problem is the penalised one: evaluations until solved by the returned point, mean
/// over the instances and seeds that both have; a run that did not solve it counts as ten budgets.
struct EntryChange {
  std::string solver, formulation, perturbation, gradient_price;
  std::string version, other_version;  ///< of the solver
  int problems = 0;
  int cheaper = 0, dearer = 0;  ///< problems on which the second store's cost is lower, is higher
  double ratio = 1;             ///< of the costs, second to first: geometric mean
  /// Of Wilcoxon's signed-rank test of the logarithms of the ratios, with Holm's correction over
  /// all entries.
  double p_value = 1;

  bool same() const { return cheaper == 0 && dearer == 0; }
  bool sure() const { return p_value < 0.05; }
};

struct EntryChanges {
  std::vector<EntryChange> entries;         ///< least p-value first, then by name
  std::vector<std::string> other_problems;  ///< names that both have, but with different hashes
};

/// Pairs the runs of two stores by entry, problem and the largest budget that both have. Throws
/// InputError if a store is damaged.
EntryChanges entry_changes(const Store& first, const Store& second);

}  // namespace ricochet::studies::comparison
