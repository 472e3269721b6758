#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace ricochet {

/// The cost for a solver to reach a target.
struct Expense {
  double evaluations;  ///< simulations without a gradient
  double gradients;    ///< simulations with one
  double overhead;     ///< the solver's own computing time [s]
};

/// Seconds to the target if a simulation takes `simulation` seconds and one with a gradient
/// `gradient_price` times as long: overhead + simulation (evaluations + gradient_price gradients).
/// Throws std::invalid_argument for a number that is negative or not finite.
double seconds_to_target(const Expense& expense, double simulation, double gradient_price);

/// The fastest solver, the first of equals: entry [i][k] is for simulations[i] and
/// gradient_prices[k]. Throws std::invalid_argument as above, or without solvers.
std::vector<std::vector<std::size_t>> cheapest_solvers(const std::vector<Expense>& expenses,
                                                       const std::vector<double>& simulations,
                                                       const std::vector<double>& gradient_prices);

/// The time of a simulation [s] at which both solvers take the same time. With cheaper simulations
/// the solver with less overhead is faster, with more expensive ones the other. Nothing if one is
/// faster at every time > 0, or both are always equal. Throws std::invalid_argument as above.
std::optional<double> break_even_simulation(const Expense& a, const Expense& b,
                                            double gradient_price);

/// The price of a gradient at which both solvers take the same time. Below it the solver with more
/// gradients is faster, above it the other. Nothing if there is no such price >= 0. Throws
/// std::invalid_argument as above, or for a simulation that takes no time.
std::optional<double> break_even_gradient_price(const Expense& a, const Expense& b,
                                                double simulation);

}  // namespace ricochet
