#include "src/benchmark/comparison/rated_families.h"

#include <algorithm>

#include "src/benchmark/comparison/group.h"
#include "src/benchmark/comparison/reported_part.h"

namespace ricochet::studies::comparison {

std::vector<RatedFamily> rated_families(const Campaign& campaign,
                                        const std::vector<CellResult>& results) {
  std::vector<RatedFamily> families;
  for (const ReportedPart& part : reported_parts(campaign)) {
    const Comparison comparison = comparison_of(campaign, results, part.usual);
    const std::vector<std::int64_t>& budgets = comparison.part->budgets;
    for (const Group& group : groups_of(comparison)) {
      RatedFamily& family = families.emplace_back();
      family.name = part.families.at(group.family);
      family.problems = group.problems.size();
      family.budget = budgets.back();
      family.ratings = rate(comparison, group.problems, budgets.size() - 1);
      for (const CellResult& result : comparison.results) {
        if (group.has(result)) family.targets[result.cell->cell.problem] = result.targets;
      }
    }
  }
  std::ranges::sort(families, {}, &RatedFamily::name);
  return families;
}

}  // namespace ricochet::studies::comparison
