#include "src/benchmark/comparison/order_data.h"

#include <iterator>
#include <set>
#include <utility>

#include "src/benchmark/comparison/order.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// Keeps every second instance, from the first or the second on; both halves have the same size.
Comparison half(Comparison comparison, std::size_t from) {
  for (CellResult& result : comparison.results) {
    result.outcomes = result.outcomes.every(2, from, result.outcomes.size() / 2);
  }
  return comparison;
}

/// Returns the order on drawn machines, for the results of this family.
std::optional<Order> order_on_drawn(const Campaign& campaign,
                                    const std::vector<CellResult>& results, std::size_t drawn,
                                    const std::string& family) {
  const Comparison comparison = comparison_of(campaign, results, {.part = drawn});
  for (const Group& group : groups_of(comparison)) {
    if (group.family != family) continue;
    return order_of(rate(comparison, group.problems, comparison.part->budgets.size() - 1));
  }
  return std::nullopt;
}

}  // namespace

Json order_data(const Comparison& comparison, const std::vector<CellResult>& results,
                const ReportedPart& part, const std::vector<Group>& groups,
                const Ratings& ratings) {
  const Campaign& campaign = *comparison.campaign;
  const std::size_t last = comparison.part->budgets.size() - 1;
  Json rows = Json::array();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Group& group = groups[g];
    const std::vector<Rating>& first = ratings[g].front().by_returned;
    const std::vector<Rating>& most = ratings[g].back().by_returned;
    const auto add = [&](const std::string& what, const Order& a, const Order& b) {
      Json row = agreement_of(a, b);
      if (row.is_null()) return;  // the orders cannot be compared
      row.update({{"family", group.family},
                  {"problems", group.problems.size()},
                  {"what", what},
                  {"leader", a.leader},
                  {"other_leader", b.leader},
                  {"same_leader", a.leader == b.leader}});
      rows.push_back(std::move(row));
    };
    const auto order = [&](const Comparison& compared, std::size_t budget) {
      return order_of(rate(compared, group.problems, budget));
    };
    if (part.repetition) {
      Conditions again = part.usual;
      again.part = *part.repetition;
      again.run = 1;
      add("other seeds", order_of(first), order(comparison_of(campaign, results, again), 0));
    }
    if (comparison.part->instances > 1) {
      add("the other half of the instances", order(half(comparison, 0), last),
          order(half(comparison, 1), last));
    }
    if (last > 0) add("more evaluations", order_of(first), order_of(most));
    if (part.drawn) {
      const auto drawn = order_on_drawn(campaign, results, *part.drawn,
                                        campaign.family_of(group.problems.front()));
      if (drawn) add("machines drawn around the cases", order_of(most), *drawn);
    }
    std::set<std::string> formulations;
    for (const Rating& rating : most) formulations.insert(rating.formulation);
    for (auto a = formulations.begin(); a != formulations.end(); ++a) {
      for (auto b = std::next(a); b != formulations.end(); ++b) {
        add(*a + " or " + *b, order_in(most, *a), order_in(most, *b));
      }
    }
  }
  return rows;
}

}  // namespace ricochet::studies::comparison
