#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/analysis/results.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/ranking.h"

namespace ricochet::comparison {

/// Share of the pairs of problem and target that an entry reached within `evaluations` for each
/// variable, with its interval over clusters of problems.
struct Reach {
  double evaluations;
  double share;
  Interval interval;
};

/// Where the progress of an entry is looked at: evaluations for each variable, six in a decade from
/// 1 on, and the budget.
std::vector<double> evaluation_places(double budget);

/// The results of one entry on a group of problems with one budget.
struct Rating {
  std::string solver;
  std::string formulation;
  bool surrogate = false;  ///< it saw a surrogate: which evaluated point is best it could not know
  int problems = 0;        ///< number of problems that the solver takes in this formulation
  int never = 0;           ///< number of these that no run solved
  double found = 0;        ///< success rate by the best evaluated points, mean over the problems
  double returned = 0;     ///< the same by the returned points
  std::vector<Reach> progress;  ///< the ECDF of runtimes
  /// Mean rank among the ranked entries, over problems and instances; ties share theirs. A problem
  /// that only some of them take counts as if all did. Empty if the entry is not ranked.
  std::optional<double> rank;
  /// Probability of having the least mean rank on problems like these. Empty if the entry is not
  /// ranked, if there is only one cluster of problems, or if no entry solved a run.
  std::optional<double> probability_of_being_best;
};

/// The name of an entry in tables and charts.
inline std::string entry(const std::string& solver, const std::string& formulation) {
  return solver + ", " + formulation;
}

/// How the ranked entries of a group did on each of its problems. Those are the entries that take
/// at least half of the problems: others cannot be compared with them.
struct RankedEntries {
  std::vector<std::string> names;     ///< as entry() has them
  std::vector<RivalsAhead> problems;  ///< those that several of them take
};

RankedEntries ranked_entries(const Comparison& comparison, const std::vector<std::size_t>& problems,
                             std::size_t budget);

/// Rates all entries of the part with budget number `budget` on these problems (indices of the
/// campaign's). The ranked ones first, by mean rank; then the others, by the number of problems
/// that they take. On every instance the entries are ranked by the optimality gap of the returned
/// point, all that solve being equal, and then by the evaluations it took.
std::vector<Rating> rate(const Comparison& comparison, const std::vector<std::size_t>& problems,
                         std::size_t budget);

/// The first of the ratings, or null if it is not ranked or solved none of its runs: who solved
/// nothing is not the best.
const Rating* leader_of(const std::vector<Rating>& ratings);

/// The entries of a family as they are ranked in a campaign's report, with the largest budget.
struct RatedFamily {
  std::string name;                                               ///< as the report has it
  std::size_t problems = 0;                                       ///< of the family
  std::int64_t budget = 0;                                        ///< evaluations per variable
  std::vector<Rating> ratings;                                    ///< best first, see rate()
  std::map<std::string, std::shared_ptr<const Targets>> targets;  ///< by problem
};

/// Draws `number` of these items, one from each of as many strata of equal size (up to one item):
/// the items sorted by their value, equal ones in the given order. In ascending order of the value.
/// All if there are no more. Deterministic in `seed`. Returns indices.
std::vector<std::size_t> stratified_sample(const std::vector<double>& values, std::size_t number,
                                           std::uint64_t seed);

}  // namespace ricochet::comparison
