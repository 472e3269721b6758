#include "src/benchmark/statistics/break_even.h"

#include <cmath>
#include <stdexcept>

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

std::optional<double> break_even_gradient_price(const Expense& a, const Expense& b,
                                                double simulation) {
  check(a);
  check(b);
  check(simulation);
  if (simulation == 0) throw std::invalid_argument("break_even_gradient_price: no time");
  const double gradients = simulation * (a.gradients - b.gradients);
  const double rest = b.overhead - a.overhead + simulation * (b.evaluations - a.evaluations);
  if (gradients == 0 || !(rest / gradients >= 0)) return std::nullopt;
  return rest / gradients;
}

}  // namespace ricochet
