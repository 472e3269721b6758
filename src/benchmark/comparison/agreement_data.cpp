#include "src/benchmark/comparison/agreement_data.h"

#include <map>
#include <string>
#include <utility>

#include "src/benchmark/comparison/group.h"
#include "src/benchmark/comparison/order.h"
#include "src/benchmark/comparison/reported_part.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

struct RatedFamily {
  std::vector<Rating> ratings;
  std::size_t problems;
};

/// The families of a campaign, as its report names them.
std::map<std::string, RatedFamily> rated_families(const Campaign& campaign,
                                                  const std::vector<CellResult>& results) {
  std::map<std::string, RatedFamily> families;
  for (const ReportedPart& part : reported_parts(campaign)) {
    const Comparison comparison = comparison_of(campaign, results, part.usual);
    for (const Group& group : groups_of(comparison)) {
      families[part.families.at(group.family)] = {
          rate(comparison, group.problems, comparison.part->budgets.size() - 1),
          group.problems.size()};
    }
  }
  return families;
}

/// Place of an entry among the ranked ones, 1 the first; null if it is none of them.
Json place_of(const Rating& wanted, const std::vector<Rating>& ratings) {
  for (std::size_t k = 0; k < ratings.size() && ratings[k].rank; ++k) {
    const Rating& rating = ratings[k];
    if (rating.solver == wanted.solver && rating.formulation == wanted.formulation) return k + 1;
  }
  return {};
}

}  // namespace

Json agreement_data(const Campaign& first, const std::vector<CellResult>& of_first,
                    const Campaign& second, const std::vector<CellResult>& of_second) {
  const auto others = rated_families(second, of_second);
  Json rows = Json::array();
  for (const auto& [family, rated] : rated_families(first, of_first)) {
    const auto other = others.find(family);
    if (other == others.end()) continue;
    const Order order = order_of(rated.ratings);
    const Order other_order = order_of(other->second.ratings);
    const Rating* leader = leader_of(rated.ratings);
    rows.push_back(
        {{"family", family},
         {"problems", rated.problems},
         {"other_problems", other->second.problems},
         {"agreement", agreement_of(order, other_order)},
         {"leader", order.leader},
         {"best", leader != nullptr ? Json(leader->probability_of_being_best) : Json()},
         {"place", leader != nullptr ? place_of(*leader, other->second.ratings) : Json()},
         {"other_leader", other_order.leader}});
  }
  return rows;
}

}  // namespace ricochet::studies::comparison
