#include "src/benchmark/comparison/order.h"

#include <set>
#include <utility>

#include "src/benchmark/statistics/rank_correlation.h"
#include "src/core/seed.h"

namespace ricochet::studies::comparison {

using report::Json;

Order order_of(const std::vector<Rating>& ratings) {
  Order order;
  if (const Rating* leader = leader_of(ratings)) {
    order.leader = entry(leader->solver, leader->formulation);
  }
  for (const Rating& r : ratings) {
    if (r.rank) order.entries[entry(r.solver, r.formulation)] = {r.solver, *r.rank};
  }
  return order;
}

Order order_in(std::vector<Rating> ratings, const std::string& formulation) {
  std::erase_if(ratings, [&](const Rating& r) { return r.formulation != formulation; });
  Order order;
  if (const Rating* leader = leader_of(ratings)) order.leader = leader->solver;
  for (const Rating& r : ratings) {
    if (r.rank) order.entries[r.solver] = {r.solver, *r.rank};
  }
  return order;
}

Json agreement_of(const Order& a, const Order& b) {
  std::vector<double> ranks_a;
  std::vector<double> ranks_b;
  std::vector<std::string> solvers;
  for (const auto& [name, ranked] : a.entries) {
    const auto other = b.entries.find(name);
    if (other == b.entries.end()) continue;
    ranks_a.push_back(ranked.rank);
    ranks_b.push_back(other->second.rank);
    solvers.push_back(ranked.solver);
  }
  if (ranks_a.size() < 2) return {};
  const auto interval = kendall_interval(ranks_a, ranks_b, solvers, seed_of("agreement", "", 0, 0));
  if (!interval) return {};
  return {{"entries", ranks_a.size()},
          {"solvers", std::set<std::string>(solvers.begin(), solvers.end()).size()},
          {"correlation", *kendall_rank_correlation(ranks_a, ranks_b)},
          {"lower", interval->lower},
          {"upper", interval->upper}};
}

}  // namespace ricochet::studies::comparison
