#pragma once

#include <map>
#include <string>
#include <vector>

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/report/results.h"

namespace ricochet::studies::comparison {

/// The ratings of a family of so many problems, best first: solver, formulation, surrogate, takes,
/// problems, rank, best (P(best)), returned and found (success rates), share (of targets reached)
/// with its interval, never (problems solved in none of its runs).
Table rating_table(std::string name, const std::vector<Rating>& ratings, std::size_t problems);

/// Success rate by the returned points of the first entries on each problem of the group, with the
/// largest budget.
report::Chart solved_map(const RatedPart& part, std::size_t group);

/// Every result on the problems of the group, for a group of few: problem, solver, formulation,
/// budget, success rates, expected running time, time, gap, each with its interval.
Table result_table(const RatedPart& part, const Group& group);

/// The problems of a group: name, variables, constraints, best_known, provenance, targets, easiest,
/// random (expected running time of random search), solving (entries that solve it in at least half
/// of their runs), entries, hash.
Table problem_table(const RatedPart& part, const Group& group,
                    const std::map<std::string, std::string>& hashes);

/// The page of a family of problems, by its own name: families that differ only in how much they
/// have of one thing share a page ("robust" has robust-mean, robust-worst and robust-cvar).
std::string page_of_family(const std::string& family);

/// A page whose families are asked about in one way.
struct FamilyPage {
  std::string folder;
  report::Results results;
};

/// The pages of all families: parts "families", one for each family as the report names it, with
/// what is asked (texts, variables, formulations, problems), who is first, ratings and charts for
/// each budget, and what compares its entries. `hashes`: of the problems in the store, by name.
std::vector<FamilyPage> family_pages(const Campaign& campaign, const std::vector<RatedPart>& parts,
                                     const std::vector<EntrySet>& sets, const Table& leaders,
                                     const Table& speed_accuracy,
                                     const std::map<std::string, std::string>& hashes);

/// The first sentences of a comparison's report: which solver, how sure, on how many problems. Of
/// the rows of leader_table() those with the largest budgets.
std::string opening_of(const Table& leaders);

}  // namespace ricochet::studies::comparison
