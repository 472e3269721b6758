#include "src/studies/contest/change_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/studies/contest/group.h"
#include "src/studies/contest/machine_results.h"
#include "src/studies/contest/order.h"
#include "src/studies/contest/reported_part.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

/// One value of what is changed.
struct Setting {
  std::string name;
  std::vector<Rating> ratings;  ///< the best first
  Order order;
};

/// A row for each setting; all are compared with the first.
void add_rows(Json& rows, const std::string& family, const std::string& changed,
              const std::vector<Setting>& settings) {
  if (settings.size() < 2) return;
  const Setting& usual = settings.front();
  for (const Setting& setting : settings) {
    const Rating& first = setting.ratings.front();
    const bool is_usual = &setting == &usual;
    rows.push_back({{"family", family},
                    {"changed", changed},
                    {"setting", setting.name},
                    {"leader", setting.order.leader},
                    {"same_leader", setting.order.leader == usual.order.leader},
                    {"best", first.probability_of_being_best},
                    {"found", first.found},
                    {"competitors", setting.ratings.size()},
                    {"agreement", is_usual ? Json() : agreement_of(usual.order, setting.order)}});
  }
}

std::vector<Rating> rated(const StoredContest& contest, const std::vector<Standing>& standings,
                          const std::vector<std::size_t>& questions) {
  return rate(contest.plan, standings, questions, contest.plan.budgets.size() - 1);
}

void add_prices(Json& rows, const Campaign& campaign, const std::vector<StoredStanding>& standings,
                const ReportedPart& part) {
  std::vector<std::string> prices = campaign.plan().parts[part.part].gradient_prices;
  std::stable_partition(prices.begin(), prices.end(), [&](const std::string& price) {
    return price == part.usual.gradient_price;
  });
  if (prices.size() < 2) return;
  std::vector<std::string> families;  // in the order of the questions
  std::map<std::string, std::vector<Setting>> settings;
  for (const std::string& price : prices) {
    Conditions conditions = part.usual;
    conditions.gradient_price = price;
    const StoredContest contest = stored_contest(campaign, standings, conditions);
    for (const Group& group : groups_of(contest)) {
      std::vector<Rating> ratings = rated(contest, contest.standings, group.questions);
      Order order = order_of(ratings);
      if (!settings.contains(group.family)) families.push_back(group.family);
      settings[group.family].push_back({price, std::move(ratings), std::move(order)});
    }
  }
  for (const std::string& family : families) {
    add_rows(rows, part.families.at(family), "price of a gradient", settings[family]);
  }
}

/// The widths of the surrogates that anybody is shown, the usual one first.
std::vector<double> widths_of(const StoredContest& contest, const Group& group, bool penalised) {
  std::set<double> found;
  for (const Standing& s : contest.standings) {
    const auto& mine = group.questions;
    if (std::find(mine.begin(), mine.end(), s.question) == mine.end()) continue;
    if (s.form.width > 0 && s.form.penalised == penalised) found.insert(s.form.width);
  }
  std::vector<double> widths(found.begin(), found.end());
  const double usual = contest.plan.questions[group.questions.front()].width;
  std::stable_partition(widths.begin(), widths.end(), [&](double w) { return w == usual; });
  return widths;
}

void add_widths(Json& rows, const StoredContest& contest, const Group& group) {
  for (const bool penalised : {false, true}) {
    std::vector<Setting> settings;
    const std::vector<double> widths = widths_of(contest, group, penalised);
    if (widths.size() < 2) continue;
    for (const double width : widths) {
      std::vector<Standing> shown = contest.standings;
      const Form form{width, penalised};
      std::erase_if(shown, [&](const Standing& s) { return s.form != form; });
      std::vector<Rating> ratings = rated(contest, shown, group.questions);
      Order order = order_in(ratings, ratings.front().form);
      settings.push_back({fmt::format("{}", width), std::move(ratings), std::move(order)});
    }
    add_rows(rows, group.family,
             penalised ? "width of the penalised surrogate" : "width of the surrogate", settings);
  }
}

void add_levels(Json& rows, const StoredContest& contest, const Group& group) {
  std::map<std::string, std::map<double, std::vector<std::size_t>>> factors;
  for (const std::size_t q : group.questions) {
    for (const auto& [name, level] : contest.plan.questions[q].factors) {
      factors[name][level].push_back(q);
    }
  }
  for (const auto& [name, levels] : factors) {
    if (levels.size() < 2) continue;
    std::vector<Setting> settings;
    for (const auto& [level, questions] : levels) {
      std::vector<Rating> ratings = rated(contest, contest.standings, questions);
      Order order = order_of(ratings);
      settings.push_back({level_name(name, level), std::move(ratings), std::move(order)});
    }
    add_rows(rows, group.family, name, settings);
  }
}

}  // namespace

Json change_data(const Campaign& campaign, const std::vector<StoredStanding>& standings,
                 const std::vector<ReportedPart>& parts) {
  Json rows = Json::array();
  for (const ReportedPart& part : parts) {
    add_prices(rows, campaign, standings, part);
    const StoredContest contest = stored_contest(campaign, standings, part.usual);
    const bool of_grid = !campaign.plan().parts[part.part].machines.around.empty();
    for (Group group : groups_of(contest)) {
      group.family = part.families.at(group.family);
      add_widths(rows, contest, group);
      if (of_grid) add_levels(rows, contest, group);
    }
  }
  return rows;
}

}  // namespace ricochet::studies::contest
