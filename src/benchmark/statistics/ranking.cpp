#include "src/benchmark/statistics/ranking.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ricochet {

Ranking ranking_of(const std::vector<std::optional<Reached>>& reached) {
  const auto key = [&](std::size_t k) { return std::pair(reached[k]->value, reached[k]->cost); };
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < reached.size(); ++k) {
    if (!reached[k]) continue;
    if (std::isnan(reached[k]->value) || std::isnan(reached[k]->cost)) {
      throw std::invalid_argument("ranking_of: a value is not a number");
    }
    order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return key(i) < key(k); });
  Ranking ranking;
  for (const std::size_t k : order) {
    if (ranking.empty() || key(ranking.back().front()) != key(k)) ranking.emplace_back();
    ranking.back().push_back(k);
  }
  return ranking;
}

}  // namespace ricochet
