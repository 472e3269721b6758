#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/report/site/entries.h"

namespace ricochet::site {

/// A solver-formulation pair that was among the best in a situation.
struct Choice {
  std::string solver, formulation;
  bool gradient;                         ///< true if it needs derivatives or residuals
  double solved;                         ///< success rate of the returned points
  std::optional<double> lower, upper;    ///< its interval of 95 %
  std::optional<double> best;            ///< probability of being the best there
  std::optional<std::int64_t> problems;  ///< that it takes
};

/// Problems that were solved with one budget, under at most one perturbation.
struct Situation {
  std::string family;
  std::string title;   ///< of the family, if it is known
  std::string folder;  ///< of the page that says more, with its anchor
  bool counts;         ///< true if the objective is a count: an integer with jumps
  std::int64_t problems;
  Extent variables, constraints;
  double budget;                     ///< evaluations for each variable
  std::string perturbation;          ///< "plain" without one
  std::optional<std::int64_t> runs;  ///< of each entry
  std::optional<double> random;      ///< evaluations that random search needs, if that is few
  std::vector<Choice> entries;       ///< the first of all, and the first without derivatives
};

/// A perturbation that a reader may have: its name, and what it is.
struct Trouble {
  std::string perturbation, words;
};

/// Which entries were best, by situation.
struct Chooser {
  std::string folder;  ///< of the comparison
  std::vector<Situation> situations;
  std::vector<Trouble> troubles;
};

RICOCHET_FIELDS(Choice, solver, formulation, gradient, solved, lower, upper, best, problems);
RICOCHET_FIELDS(Situation, family, title, folder, counts, problems, variables, constraints, budget,
                perturbation, runs, random, entries);
RICOCHET_FIELDS(Trouble, perturbation, words);
RICOCHET_FIELDS(Chooser, folder, situations, troubles);

/// Titles of families of problems, by name.
using FamilyTitles = std::map<std::string, std::string>;

/// Returns the titles that the first report of the problems knows.
FamilyTitles family_titles(const std::vector<FoundReport>& reports);

/// Collects the situations of a comparison: of each of its families with each budget, by mean rank;
/// and of each family that was run under perturbations, by success rate. Entries that solved
/// nothing are left out. The title of a family is that of the longest name with which its own
/// begins. Throws Json::exception if its data are of another version.
Chooser chooser_of(const FoundReport& comparison, const FamilyTitles& titles = {});

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

RICOCHET_FIELDS(PairedSolver, solver, formulation, evaluations, own, solved, solved_lower,
                solved_upper);
RICOCHET_FIELDS(PairedSimulation, simulation, control, reference, seconds, error, error_least);
RICOCHET_FIELDS(Pairs, folder, comparison, family, cases, tolerance, range, solvers, simulations);

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
