#include "src/analysis/statistics/break_even.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "src/analysis/statistics/running_time.h"

namespace ricochet {

namespace {

void check(double number) {
  if (!(number >= 0 && std::isfinite(number))) {
    throw std::invalid_argument("break-even: numbers must be finite and >= 0");
  }
}

void check(const Expense& expense) {
  check(expense.evaluations);
  check(expense.gradients);
  check(expense.overhead);
}

}  // namespace

double seconds_to_target(const Expense& expense, double simulation, double gradient_price) {
  check(expense);
  check(simulation);
  check(gradient_price);
  return expense.overhead + simulation * (expense.evaluations + gradient_price * expense.gradients);
}

std::vector<std::vector<std::size_t>> cheapest_solvers(const std::vector<Expense>& expenses,
                                                       const std::vector<double>& simulations,
                                                       const std::vector<double>& gradient_prices) {
  if (expenses.empty()) throw std::invalid_argument("cheapest_solvers: no solvers");
  std::vector<std::vector<std::size_t>> cheapest;
  for (const double simulation : simulations) {
    cheapest.emplace_back();
    for (const double price : gradient_prices) {
      std::size_t best = 0;
      double least = seconds_to_target(expenses[0], simulation, price);
      for (std::size_t k = 1; k < expenses.size(); ++k) {
        const double seconds = seconds_to_target(expenses[k], simulation, price);
        if (!(seconds < least)) continue;
        best = k;
        least = seconds;
      }
      cheapest.back().push_back(best);
    }
  }
  return cheapest;
}

std::optional<double> break_even_simulation(const Expense& a, const Expense& b,
                                            double gradient_price) {
  check(a);
  check(b);
  check(gradient_price);
  const double simulations =
      a.evaluations - b.evaluations + gradient_price * (a.gradients - b.gradients);
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
