#include "src/cli/finished_campaign.h"

#include <utility>

#include "src/benchmark/experiment/campaign/archived_campaign.h"
#include "src/cli/archive.h"
#include "src/research/suite/catalogue.h"

namespace ricochet::cli {

FinishedCampaign finished_campaign(const std::string& store) {
  const Store opened = Store::open(archive_named(store), Store::For::reading);
  const Catalogue catalogue = studies::whole_catalogue();
  const Plan plan = plan_against(opened.description(), {}, catalogue);
  Campaign campaign = campaign_of(opened.description(), plan, catalogue);
  auto results = comparison::cell_results(campaign, opened, [](const StoredRun&) {});
  return {std::move(campaign), std::move(results)};
}

}  // namespace ricochet::cli
