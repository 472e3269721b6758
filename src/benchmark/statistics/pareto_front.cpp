#include "src/benchmark/statistics/pareto_front.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace ricochet {

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points) {
  for (const CostAndError& point : points) {
    if (std::isnan(point.cost) || std::isnan(point.error)) {
      throw std::invalid_argument("pareto_front: a value is not a number");
    }
  }
  const auto pair = [&](std::size_t k) { return std::tuple(points[k].cost, points[k].error); };
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return pair(i) < pair(k); });
  std::vector<std::size_t> front;
  for (const std::size_t k : order) {
    if (front.empty() || points[k].error < points[front.back()].error ||
        pair(k) == pair(front.back())) {
      front.push_back(k);
    }
  }
  return front;
}

}  // namespace ricochet
