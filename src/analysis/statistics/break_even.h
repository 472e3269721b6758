#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "src/analysis/statistics/running_time.h"

namespace ricochet {

/// The cost for a solver to reach a target. Numbers are finite and >= 0; the functions throw
/// std::invalid_argument for others.
struct Expense {
  double simulations;
  double overhead;  ///< the solver's own computing time [s]
};

/// Seconds to the target if a simulation takes `simulation` seconds.
double seconds_to_target(const Expense& expense, double simulation);

/// The index of the fastest solver, the first of equals. Throws std::invalid_argument without
/// solvers.
std::size_t cheapest_solver(const std::vector<Expense>& expenses, double simulation);

/// The time of a simulation [s] at which both solvers take the same time. With cheaper simulations
/// the solver with less overhead is faster, with more expensive ones the other. Nothing if one is
/// faster at every time > 0, or both are always equal.
std::optional<double> break_even_simulation(const Expense& a, const Expense& b);

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
