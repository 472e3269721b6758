#include "src/benchmark/comparison/order.h"

#include "src/benchmark/statistics/rank_correlation.h"

namespace ricochet::studies::comparison {

using report::Json;

Order order_of(const std::vector<Rating>& ratings) {
  Order order;
  for (const Rating& r : ratings) {
    const std::string name = entry(r.solver, r.formulation);
    if (order.leader.empty()) order.leader = name;
    order.ranks[name] = r.rank;
  }
  return order;
}

Order order_in(const std::vector<Rating>& ratings, const std::string& formulation) {
  Order order;
  for (const Rating& r : ratings) {
    if (r.formulation != formulation) continue;
    if (order.leader.empty()) order.leader = r.solver;
    order.ranks[r.solver] = r.rank;
  }
  return order;
}

Json agreement_of(const Order& a, const Order& b) {
  std::vector<double> ranks_a;
  std::vector<double> ranks_b;
  for (const auto& [name, rank] : a.ranks) {
    const auto other = b.ranks.find(name);
    if (other == b.ranks.end()) continue;
    ranks_a.push_back(rank);
    ranks_b.push_back(other->second);
  }
  if (ranks_a.size() < 5) return {};
  const auto correlation = kendall_rank_correlation(ranks_a, ranks_b);
  if (!correlation) return {};
  const Interval interval = kendall_interval(*correlation, ranks_a.size());
  return {{"entries", ranks_a.size()},
          {"correlation", *correlation},
          {"lower", interval.lower},
          {"upper", interval.upper}};
}

}  // namespace ricochet::studies::comparison
