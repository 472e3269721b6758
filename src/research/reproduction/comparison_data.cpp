#include "src/benchmark/comparison/group.h"
#include "src/research/reproduction/data.h"

namespace ricochet::studies::reproduction {

report::Json comparison_data(const std::optional<StoredCampaign>& comparison) {
  using namespace comparison;
  if (!comparison) return {{"problems", 0}, {"groups", report::Json::array()}};
  const Campaign& campaign = comparison->campaign;
  const Comparison compared =
      comparison_of(campaign, cell_results(campaign, comparison->store), Conditions());
  const std::vector<Group> groups = groups_of(compared);
  return {{"problems", campaign.problems().size()},
          {"groups", group_data(compared, groups, ratings_of(compared, groups))}};
}

}  // namespace ricochet::studies::reproduction
