#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/report/site/found_report.h"

namespace ricochet::site {

/// The smallest and the largest of some numbers.
struct Extent {
  std::int64_t least, most;
};

/// The problems of a family, or "all".
struct FamilySize {
  std::string name;
  std::size_t problems;
  Extent variables, constraints;
};

struct FamilyProblem;

/// Returns the size of a family of problems, or of all of them.
FamilySize size_of(const std::string& name, const std::vector<FamilyProblem>& problems);

/// A solver-formulation pair on a family with a budget. A missing value was not rated or not
/// measured.
struct Entry {
  std::size_t family = {};          ///< its number in the comparison
  double budget = {};               ///< evaluations per variable; 0: the largest of each family
  std::size_t place = {}, of = {};  ///< among the entries with ratings
  std::string solver = {}, formulation = {};
  bool outside = {};                ///< not one of ricochet's own
  std::optional<double> best = {};  ///< probability of being the best
  std::optional<double> targets = {}, lower = {}, upper = {};
  std::optional<double> returned = {};  ///< success rate of the returned points
  std::optional<std::int64_t> never = {};
  std::optional<double> rank = {};
  // Speed against accuracy, over the runs:
  std::optional<double> evaluations = {};  ///< for each variable
  std::optional<double> seconds = {};
  std::optional<double> solved = {}, solved_lower = {}, solved_upper = {};
  std::optional<double> error = {}, error_lower = {}, error_upper = {};  ///< the median
  bool complete = {};  ///< true if it takes all problems that any entry takes
};

/// The share of targets that an entry reaches, over the evaluations.
struct Curve {
  std::size_t family;
  double budget;
  std::string solver, formulation;
  std::vector<std::vector<double>> points;  ///< evaluations per variable, share
};

/// A comparison of solvers for the front page. For each family and budget it has the first 15
/// entries, and also those with speed against accuracy and the external ones.
struct Comparison {
  std::string folder;
  std::vector<FamilySize> families;
  std::vector<Entry> entries;  ///< by family, budget and place
  std::vector<Curve> curves;
  std::map<std::string, std::string> kinds;  ///< of the solvers, if the data have them
};

/// Solvers that charts name wherever they lie: the paper's algorithm, and random search.
inline constexpr const char* always_named[] = {"fireworks", "random-search"};

RICOCHET_JSON(Extent, least, most);
RICOCHET_JSON(FamilySize, name, problems, variables, constraints);
RICOCHET_WRITTEN_AS_JSON(Entry, family, budget, place, of, solver, formulation, outside, best,
                         targets, lower, upper, returned, never, rank, evaluations, seconds, solved,
                         solved_lower, solved_upper, error, error_lower, error_upper, complete);
RICOCHET_WRITTEN_AS_JSON(Curve, family, budget, solver, formulation, points);
RICOCHET_WRITTEN_AS_JSON(Comparison, folder, families, entries, curves, kinds);

/// Returns the comparison of a report that holds "entries", with its pages that hold a "family".
/// Throws Json::exception if their data are of another version.
Comparison comparison_of(const FoundReport& report);

/// Returns the report with most runs among those that hold "entries"; null if there is none.
const FoundReport* largest_comparison(const std::vector<FoundReport>& reports);

}  // namespace ricochet::site
