#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "src/analysis/statistics/running_time.h"

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

/// The least cost of each problem: that of a virtual solver that always picks the best one present.
/// Infinite if none solved it. Throws std::invalid_argument for invalid costs.
std::vector<double> virtual_best(const Costs& costs);

/// A point with two values to be minimised; infinite values are allowed.
struct CostAndError {
  double cost, error;
};

/// Indices of the Pareto front: the points that no other point dominates, by rising cost; all of
/// several equal points. Throws std::invalid_argument for a value that is no number.
std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points);

}  // namespace ricochet
