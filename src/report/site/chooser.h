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

RICOCHET_WRITTEN_AS_JSON(Choice, solver, formulation, gradient, solved, lower, upper, best,
                         problems);
RICOCHET_WRITTEN_AS_JSON(Situation, family, title, folder, counts, problems, variables, constraints,
                         budget, perturbation, runs, random, entries);
RICOCHET_WRITTEN_AS_JSON(Trouble, perturbation, words);
RICOCHET_WRITTEN_AS_JSON(Chooser, folder, situations, troubles);

/// Titles of families of problems, by name.
using FamilyTitles = std::map<std::string, std::string>;

/// Returns the titles that the first report of the problems knows.
FamilyTitles family_titles(const std::vector<FoundReport>& reports);

/// Collects the situations of a comparison: of each of its families with each budget, by mean rank;
/// and of each family that was run under perturbations, by success rate. Entries that solved
/// nothing are left out. The title of a family is that of the longest name with which its own
/// begins. Throws Json::exception if its data are of another version.
Chooser chooser_of(const FoundReport& comparison, const FamilyTitles& titles = {});

}  // namespace ricochet::site
