#include "src/benchmark/statistics/costs.h"

#include <stdexcept>

namespace ricochet {

std::size_t check_costs(const Costs& costs) {
  if (costs.empty() || costs.front().empty()) {
    throw std::invalid_argument("costs: a problem and a solver are needed");
  }
  for (const std::vector<double>& row : costs) {
    if (row.size() != costs.front().size()) {
      throw std::invalid_argument("costs: every problem needs a cost of every solver");
    }
    for (const double cost : row) {
      if (!(cost > 0)) throw std::invalid_argument("costs: a cost must be > 0");
    }
  }
  return costs.front().size();
}

Costs costs_of_pair(const Costs& costs, std::size_t a, std::size_t b) {
  const std::size_t solvers = check_costs(costs);
  if (a >= solvers || b >= solvers) throw std::invalid_argument("costs_of_pair: no such solver");
  Costs pair;
  for (const std::vector<double>& row : costs) pair.push_back({row[a], row[b]});
  return pair;
}

}  // namespace ricochet
