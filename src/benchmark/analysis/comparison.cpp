#include "src/benchmark/analysis/comparison.h"

#include <algorithm>

namespace ricochet::comparison {

std::vector<std::size_t> Comparison::problems() const {
  std::vector<std::size_t> all;
  for (const CellResult& result : results) {
    const std::size_t problem = result.cell->problem;
    if (std::find(all.begin(), all.end(), problem) == all.end()) all.push_back(problem);
  }
  return all;
}

Comparison comparison_of(const Campaign& campaign, const std::vector<CellResult>& results,
                         const Conditions& conditions) {
  const PlanPart& part = campaign.plan().parts[conditions.part];
  Comparison comparison{&campaign, &part, conditions.run, {}};
  for (const CellResult& result : results) {
    const PlannedCell& cell = *result.cell;
    const bool asked =
        std::find(cell.parts.begin(), cell.parts.end(), conditions.part) != cell.parts.end() &&
        cell.cell.perturbation == conditions.perturbation &&
        cell.cell.gradient_price == conditions.gradient_price && conditions.run < cell.seeds;
    if (!asked) continue;
    comparison.results.push_back({&cell,
                                  result.outcomes.every(static_cast<std::size_t>(cell.seeds),
                                                        static_cast<std::size_t>(conditions.run),
                                                        static_cast<std::size_t>(part.instances)),
                                  result.targets});
  }
  return comparison;
}

}  // namespace ricochet::comparison
