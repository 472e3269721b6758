#pragma once

#include <string>
#include <vector>

#include "src/benchmark/analysis/comparison.h"
#include "src/benchmark/statistics/interval.h"

namespace ricochet::comparison {

/// Share of the pairs of problem and target that an entry reached within `evaluations` for each
/// variable, with its interval over problems.
struct Reach {
  double evaluations;
  double share;
  Interval interval;
};

/// The results of one entry on a group of problems with one budget.
struct Rating {
  std::string solver;
  std::string formulation;
  int problems = 0;             ///< number of problems that the solver takes in this formulation
  int never = 0;                ///< number of these that no run solved
  double found = 0;             ///< success rate, mean over the problems
  double returned = 0;          ///< the same for the returned points
  std::vector<Reach> progress;  ///< the ECDF of runtimes
  double probability_of_being_best = 0;  ///< Plackett-Luce model of all problems' rankings
  double rank = 0;                       ///< mean over problems and instances, ties share theirs
};

/// The name of an entry in tables and charts.
inline std::string entry(const std::string& solver, const std::string& formulation) {
  return solver + ", " + formulation;
}

/// Optimality gaps that are the targets of a problem: its own tolerance, and larger ones.
std::vector<double> targets_of(const Problem& problem);

/// Rates all entries of the part with budget number `budget` on these problems (indices of the
/// campaign's). Sorted by probability of being best, the largest first, then by mean rank. On every
/// instance the entries are ranked by the best optimality gap and then by the evaluations it took.
std::vector<Rating> rate(const Comparison& comparison, const std::vector<std::size_t>& problems,
                         std::size_t budget);

}  // namespace ricochet::comparison
