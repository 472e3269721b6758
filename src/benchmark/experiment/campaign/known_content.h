#pragma once

#include <string>

#include "src/benchmark/experiment/campaign/campaign.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet {

/// Says in what a run contradicts its campaign: another budget than the plan's, a point of another
/// length, an objective that is proven to be out of reach. Empty if in nothing, or if the campaign
/// has no such run.
std::string contradiction(const Campaign& campaign, const StoredRun& run);

/// Says in what a store's problem differs from the campaign's of this name and hash; empty if in
/// nothing, or if there is none.
std::string contradiction(const CampaignDescription& ours, const StoredProblem& theirs);

/// The content of a store, compared with what this program knows. Throws InputError, naming `file`
/// and what contradicts it.
void check_content(const Campaign& campaign, const Store& store, const std::string& file);

}  // namespace ricochet
