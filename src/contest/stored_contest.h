#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "src/campaign/campaign.h"
#include "src/contest/contest.h"

namespace ricochet::contest {

/// All runs of one cell of a campaign, judged, by instance, then run.
struct StoredStanding {
  const PlannedCell* cell;
  Outcomes outcomes;
};

/// Every cell of a campaign with its outcomes. Each run of the store is read once, and handed to
/// `also`, too, as Store::each does. Throws InputError where the store lacks runs.
std::vector<StoredStanding> stored_standings(
    const Campaign& campaign, const Store& store,
    const std::function<void(const StoredRun&)>& also = [](const StoredRun&) {});

/// By question, an index of the campaign's, the largest budget that it is put to anybody with.
std::map<std::size_t, std::int64_t> largest_budgets(const std::vector<StoredStanding>& standings);

/// What is compared within a contest: cells that differ in question, solver, form and budget only.
struct Conditions {
  std::size_t part = 0;  ///< of the plan
  std::string feature = "plain";
  std::string gradient_price = "n";
  int run = 0;
};

struct StoredContest {
  ContestPlan plan;
  std::vector<std::string> families;  ///< of the plan's questions
  std::vector<Standing> standings;
};

/// The contest of one part of a campaign under these conditions, as if it had been held.
StoredContest stored_contest(const Campaign& campaign, const std::vector<StoredStanding>& standings,
                             const Conditions& conditions);

}  // namespace ricochet::contest
