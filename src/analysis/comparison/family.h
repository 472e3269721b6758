#pragma once

#include <map>
#include <string>
#include <vector>

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/report/results.h"

namespace ricochet::studies::comparison {

/// The page of a family of problems, by its own name: families that differ only in how much they
/// have of one thing share a page ("robust" has robust-mean, robust-worst and robust-cvar).
std::string page_of_family(const std::string& family);

/// A page whose families are asked about in one way.
struct FamilyPage {
  std::string folder;
  report::Results results;
};

/// The pages of all families: parts "families", one for each family as the report names it, with what
/// is asked (texts, variables, formulations, problems), who is first, ratings and charts for each
/// budget, and what compares its entries. `hashes`: of the problems in the store, by name.
std::vector<FamilyPage> family_pages(const Campaign& campaign, const std::vector<RatedPart>& parts,
                                     const std::vector<EntrySet>& sets, const Table& leaders,
                                     const Table& speed_accuracy,
                                     const std::map<std::string, std::string>& hashes);

/// The first sentences of a comparison's report: which solver, how sure, on how many problems. Of
/// the rows of leader_table() those with the largest budgets.
std::string opening_of(const Table& leaders);

}  // namespace ricochet::studies::comparison
