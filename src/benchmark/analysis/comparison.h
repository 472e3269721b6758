#pragma once

#include <string>
#include <vector>

#include "src/benchmark/analysis/cell_results.h"

namespace ricochet::comparison {

/// The conditions shared by all results of a comparison.
struct Conditions {
  std::size_t part = 0;  ///< of the plan
  std::string perturbation = "plain";
  std::string gradient_price = "n";
  int run = 0;
};

/// Results of one part of a campaign under the same conditions: their cells differ only in problem,
/// formulation, solver and budget, and each has one outcome for each instance.
struct Comparison {
  const Campaign* campaign;
  const PlanPart* part;
  int run;  ///< number of the runs
  std::vector<CellResult> results;

  const Problem& problem_of(const CellResult& result) const {
    return campaign->problems()[result.cell->problem];
  }

  /// Indices into the campaign's problems, in order of first occurrence.
  std::vector<std::size_t> problems() const;
};

/// The campaign must outlive the result.
Comparison comparison_of(const Campaign& campaign, const std::vector<CellResult>& results,
                         const Conditions& conditions);

}  // namespace ricochet::comparison
