#include "src/cli/finished_campaign.h"

#include <utility>

#include "src/cli/recorded_campaign.h"

namespace ricochet::cli {

FinishedCampaign finished_campaign(const Store& store) {
  Campaign campaign = recorded_campaign(store);
  auto results = comparison::cell_results(campaign, store, [](const StoredRun&) {});
  return {std::move(campaign), std::move(results)};
}

}  // namespace ricochet::cli
