#include "src/cli/finished_campaign.h"

#include <utility>

#include "src/benchmark/experiment/campaign/archived_campaign.h"
#include "src/research/suite/catalogue.h"

namespace ricochet::cli {

FinishedCampaign finished_campaign(const Store& store) {
  const Catalogue catalogue = studies::whole_catalogue();
  const Plan plan = plan_against(store.description(), {}, catalogue);
  Campaign campaign = campaign_of(store.description(), plan, catalogue);
  auto results = comparison::cell_results(campaign, store, [](const StoredRun&) {});
  return {std::move(campaign), std::move(results)};
}

}  // namespace ricochet::cli
