#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace ricochet {

/// What a solver needs to reach a target.
struct Expense {
  double evaluations;  ///< simulations without a gradient
  double gradients;    ///< simulations with one
  double overhead;     ///< its own computing [s]
};

/// Seconds to the target where a simulation takes `simulation` seconds and one with a gradient
/// `gradient_price` times that: overhead + simulation (evaluations + gradient_price gradients).
/// Throws std::invalid_argument for a number that is negative or not finite.
double seconds_to_target(const Expense& expense, double simulation, double gradient_price);

/// The solver that takes least, the first of equals: entry [i][k] is for simulations[i] and
/// gradient_prices[k]. Throws std::invalid_argument as above, or without solvers.
std::vector<std::vector<std::size_t>> cheapest_solvers(const std::vector<Expense>& expenses,
                                                       const std::vector<double>& simulations,
                                                       const std::vector<double>& gradient_prices);

/// Seconds a simulation must take for both to take as long: with cheaper ones the solver of less
/// overhead is ahead, with dearer ones the other. Nothing where one is ahead at any cost > 0, or
/// both are always level. Throws std::invalid_argument as above.
std::optional<double> break_even_simulation(const Expense& a, const Expense& b,
                                            double gradient_price);

/// The gradient's price at which both take as long: below it the solver of more gradients is ahead,
/// above it the other. Nothing where there is none >= 0. Throws std::invalid_argument as above, or
/// for a simulation that takes no time.
std::optional<double> break_even_gradient_price(const Expense& a, const Expense& b,
                                                double simulation);

}  // namespace ricochet
