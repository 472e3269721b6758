#include "src/benchmark/comparison/held_out_data.h"

#include "src/benchmark/statistics/held_out_order.h"
#include "src/core/seed.h"

namespace ricochet::studies::comparison {

using report::Json;

Json held_out_data(const Comparison& comparison, const std::vector<Group>& groups) {
  Json rows = Json::array();
  for (const Group& group : groups) {
    const RankedEntries ranked =
        ranked_entries(comparison, group.problems, comparison.part->budgets.size() - 1);
    const auto order = held_out_order(ranked.problems, ranked.names.size(),
                                      seed_of("held out", group.family, 0, 0));
    Json row = {{"family", group.family},
                {"problems", group.problems.size()},
                {"entries", ranked.names.size()},
                {"measured", order.has_value()}};
    if (order) {
      row.update({{"correlation", order->correlation},
                  {"lower", order->interval.lower},
                  {"upper", order->interval.upper},
                  {"first_stays", order->first_stays}});
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace ricochet::studies::comparison
