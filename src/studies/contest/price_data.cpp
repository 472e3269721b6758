#include "src/studies/contest/price_data.h"

#include <map>
#include <string>

#include "src/statistics/rank_correlation.h"
#include "src/studies/contest/group.h"

namespace ricochet::studies::contest {

using report::Json;

Json price_data(const Campaign& campaign, const std::vector<StoredStanding>& standings) {
  Json rows = Json::array();
  for (std::size_t part = 0; part < campaign.plan().parts.size(); ++part) {
    const auto& prices = campaign.plan().parts[part].gradient_prices;
    if (prices.size() < 2) continue;
    std::map<std::string, std::map<std::string, double>> usual;  // ranks by family, competitor
    std::vector<std::string> order = {"n"};                      // the others are compared with it
    for (const std::string& price : prices) {
      if (price != "n") order.push_back(price);
    }
    for (const std::string& price : order) {
      const StoredContest contest =
          stored_contest(campaign, standings, {.part = part, .gradient_price = price});
      if (contest.standings.empty()) continue;
      for (const Group& group : groups_of(contest)) {
        const auto ratings =
            rate(contest.plan, contest.standings, group.questions, contest.plan.budgets.size() - 1);
        std::vector<double> now;
        std::vector<double> then;
        for (const Rating& rating : ratings) {
          const std::string name = competitor(rating.solver, rating.form);
          if (price == "n") usual[group.family][name] = rating.rank;
          const auto& known = usual[group.family];
          if (const auto found = known.find(name); found != known.end()) {
            now.push_back(rating.rank);
            then.push_back(found->second);
          }
        }
        const auto correlation =
            now.size() >= 5 ? kendall_rank_correlation(now, then) : std::nullopt;
        rows.push_back({{"family", group.family},
                        {"price", price},
                        {"leader", competitor(ratings[0].solver, ratings[0].form)},
                        {"best", ratings[0].probability_of_being_best},
                        {"found", ratings[0].found},
                        {"competitors", ratings.size()},
                        {"correlation", correlation}});
      }
    }
  }
  return rows;
}

}  // namespace ricochet::studies::contest
