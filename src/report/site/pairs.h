#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/report/site/entries.h"

namespace ricochet::site {

/// A solver whose evaluations are all simulations.
struct PairedSolver {
  std::string solver, formulation;
  double evaluations;                         ///< mean until solved, or of the whole run
  double own;                                 ///< [s] of processor time, without the simulations
  double solved, solved_lower, solved_upper;  ///< share of the runs, with its interval
};

/// A method of simulation.
struct PairedSimulation {
  std::string simulation, control;
  bool reference;
  double seconds;                            ///< [s] per simulation
  std::optional<double> error, error_least;  ///< [rad/s] of the answer, over the cases
};

/// Solvers and simulations that can be combined, with cost and error of each.
struct Pairs {
  std::string folder;      ///< of the simulations
  std::string comparison;  ///< folder of the solvers
  std::string family;      ///< of problems
  std::vector<std::string> cases;
  double tolerance;  ///< [rad/s] within which an answer counts as correct
  double range;      ///< [rad/s], the fastest answer: no answer is farther off than this tells
  std::vector<PairedSolver> solvers;
  std::vector<PairedSimulation> simulations;
};

RICOCHET_WRITTEN_AS_JSON(PairedSolver, solver, formulation, evaluations, own, solved, solved_lower,
                         solved_upper);
RICOCHET_JSON(PairedSimulation, simulation, control, reference, seconds, error, error_least);
RICOCHET_WRITTEN_AS_JSON(Pairs, folder, comparison, family, cases, tolerance, range, solvers,
                         simulations);

/// Combines the simulations of a report that holds "simulations" with the solvers of a comparison
/// on the same family, with the largest budget. Nothing if one of them is missing. Throws
/// Json::exception if the data are of another version.
std::optional<Pairs> pairs_of(const FoundReport& simulating, const FoundReport& comparing);

/// A solver with a simulation.
struct Pair {
  std::size_t solver, simulation;  ///< indices in the lists
  double seconds;  ///< expected until solved, where a run that fails is repeated: (own +
                   ///< evaluations * seconds of a simulation) / solved
  double error;  ///< [rad/s], upper bound: the simulation's, plus the tolerance; at most the range
};

std::vector<Pair> all_pairs(const Pairs& pairs);

/// Returns the Pareto front, by rising time; of equal pairs the first.
std::vector<Pair> leading(std::vector<Pair> pairs);

/// Returns the pairs with an error within the range; all if none has.
std::vector<Pair> within_range(const Pairs& pairs);

/// Returns e.g. "bisection, event-driven", with the tolerance or step size if there is one.
std::string name_of(const Pairs& pairs, const Pair& pair);

/// Summarises the pairs in a title and in a sentence.
std::string title_of(const Pairs& pairs);
std::string finding_of(const Pairs& pairs);

}  // namespace ricochet::site
