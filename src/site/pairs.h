#pragma once

#include <string>
#include <vector>

#include "src/site/found_report.h"

namespace ricochet::site {

/// Solvers and simulations that can be put together: what a threshold costs by both, and how wrong
/// it is. Of the contest the solvers that are shown a count of the family top-speed, with the
/// largest budget:
///   solver, form   a count is all that they ask of a simulation
///   evaluations    mean until solved, or in all
///   own            [s] of processor time that is not the simulation's
///   solved, solved_lower, solved_upper  share of the runs, with its interval
/// Of the dynamics the simulations: name, control, reference, seconds [s] a simulation, error and
/// error_least [rad/s] of the threshold, the largest and the smallest of the cases. And tolerance
/// [rad/s], within which the contest counts a threshold as found. Null where either is missing.
Json pairs_data(const std::vector<FoundReport>& reports);

/// A solver with a simulation.
struct SolverSimulation {
  std::size_t solver, simulation;  ///< places in the data
  double seconds;  ///< expected until solved, where a run that fails is repeated: (own +
                   ///< evaluations * seconds of a simulation) / solved
  double error;    ///< [rad/s], at most: the simulation's, and the contest's tolerance
};

/// All pairs of data that are not null.
std::vector<SolverSimulation> pairs_of(const Json& data);

/// Those that no other one beats in both, by rising time; of equal ones the first.
std::vector<SolverSimulation> front_of_pairs(std::vector<SolverSimulation> pairs);

/// "bisection, event-driven", with the control where there is one.
std::string name_of_pair(const Json& data, const SolverSimulation& pair);

/// What the pairs say, as a title and in a sentence.
std::string pairs_title(const Json& data);
std::string pairs_finding(const Json& data);

}  // namespace ricochet::site
