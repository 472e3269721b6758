#include "src/analysis/statistics/break_even.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "src/analysis/statistics/running_time.h"

namespace ricochet {

namespace {

void check(std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    if (!(number >= 0 && std::isfinite(number))) {
      throw std::invalid_argument("break-even: numbers must be finite and >= 0");
    }
  }
}

}  // namespace

double seconds_to_target(const Expense& expense, double simulation) {
  check({expense.simulations, expense.overhead, simulation});
  return expense.overhead + simulation * expense.simulations;
}

std::size_t cheapest_solver(const std::vector<Expense>& expenses, double simulation) {
  if (expenses.empty()) throw std::invalid_argument("cheapest_solver: no solvers");
  std::size_t best = 0;
  for (std::size_t k = 1; k < expenses.size(); ++k) {
    if (seconds_to_target(expenses[k], simulation) < seconds_to_target(expenses[best], simulation))
      best = k;
  }
  return best;
}

std::optional<double> break_even_simulation(const Expense& a, const Expense& b) {
  check({a.simulations, a.overhead, b.simulations, b.overhead});
  const double simulations = a.simulations - b.simulations;
  const double overhead = b.overhead - a.overhead;
  if (simulations == 0 || !(overhead / simulations > 0)) return std::nullopt;
  return overhead / simulations;
}

std::vector<double> virtual_best(const Costs& costs) {
  check_costs(costs);
  std::vector<double> best;
  for (const std::vector<double>& row : costs) {
    best.push_back(*std::min_element(row.begin(), row.end()));
  }
  return best;
}

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
