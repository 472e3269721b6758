#include "src/benchmark/comparison/agreement_data.h"

#include <algorithm>
#include <string>

#include "src/benchmark/comparison/order.h"
#include "src/benchmark/comparison/rated_families.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

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
  const std::vector<RatedFamily> others = rated_families(second, of_second);
  Json rows = Json::array();
  for (const RatedFamily& rated : rated_families(first, of_first)) {
    const auto other = std::ranges::find(others, rated.name, &RatedFamily::name);
    if (other == others.end()) continue;
    const Order order = order_of(rated.ratings);
    const Order other_order = order_of(other->ratings);
    const Rating* leader = leader_of(rated.ratings);
    rows.push_back({{"family", rated.name},
                    {"problems", rated.problems},
                    {"other_problems", other->problems},
                    {"agreement", agreement_of(order, other_order)},
                    {"leader", order.leader},
                    {"best", leader != nullptr ? Json(leader->probability_of_being_best) : Json()},
                    {"place", leader != nullptr ? place_of(*leader, other->ratings) : Json()},
                    {"other_leader", other_order.leader}});
  }
  return rows;
}

}  // namespace ricochet::studies::comparison
