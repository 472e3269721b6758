#include "src/cli/agreement.h"

#include <fmt/format.h>

#include "src/benchmark/comparison/agreement_data.h"
#include "src/cli/agreement_text.h"
#include "src/cli/finished_campaign.h"

namespace ricochet::cli {
namespace {

using report::Json;

std::string family_in_words(const Json& row) {
  const std::string leader = row["leader"];
  const std::string sure =
      row["best"].is_null() ? "" : fmt::format(", P(best) {:.2f}", row["best"].get<double>());
  const std::string place = row["place"].is_null()
                                ? "is not ranked"
                                : fmt::format("has place {}", row["place"].get<int>());
  return fmt::format(
      "{}: {} and {} problems; {}; the first of the one ({}{}) {} in the other, "
      "whose first is {}\n",
      row["family"].get<std::string>(), row["problems"].get<int>(),
      row["other_problems"].get<int>(), agreement_in_words(row["agreement"]), leader, sure, place,
      row["other_leader"].get<std::string>());
}

}  // namespace

int compare_stores(const std::string& first, const std::string& second, bool json) {
  const FinishedCampaign one = finished_campaign(first);
  const FinishedCampaign other = finished_campaign(second);
  const Json rows =
      studies::comparison::agreement_data(one.campaign, one.results, other.campaign, other.results);
  if (json) {
    fmt::print("{}\n", rows.dump(2));
    return 0;
  }
  for (const Json& row : rows) fmt::print("{}", family_in_words(row));
  return 0;
}

}  // namespace ricochet::cli
