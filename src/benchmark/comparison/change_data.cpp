#include "src/benchmark/comparison/change_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/benchmark/comparison/group.h"
#include "src/benchmark/comparison/machine_results.h"
#include "src/benchmark/comparison/order.h"
#include "src/benchmark/comparison/reported_part.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// One value of the setting that is varied.
struct Setting {
  std::string name;
  std::vector<Rating> ratings;  ///< the best first
  Order order;
  std::size_t problems;
};

/// A row for each setting; all are compared with the first.
void add_rows(Json& rows, const std::string& family, const std::string& changed,
              const std::vector<Setting>& settings) {
  if (settings.size() < 2) return;
  const Setting& usual = settings.front();
  for (const Setting& setting : settings) {
    const Rating* first = leader_of(setting.ratings);
    const auto of_first = [&](const auto& value) { return first ? Json(value(*first)) : Json(); };
    const bool is_usual = &setting == &usual;
    rows.push_back(
        {{"family", family},
         {"changed", changed},
         {"setting", setting.name},
         {"leader", setting.order.leader},
         {"same_leader", setting.order.leader == usual.order.leader},
         {"best", of_first([](const Rating& r) { return Json(r.probability_of_being_best); })},
         {"returned", of_first([](const Rating& r) { return Json(r.returned); })},
         {"problems", setting.problems},
         {"entries", setting.order.entries.size()},
         {"agreement", is_usual ? Json() : agreement_of(usual.order, setting.order)}});
  }
}

std::vector<Rating> rated(const Comparison& comparison, const std::vector<std::size_t>& problems) {
  return rate(comparison, problems, comparison.part->budgets.size() - 1);
}

void add_prices(Json& rows, const Campaign& campaign, const std::vector<CellResult>& results,
                const ReportedPart& part) {
  std::vector<std::string> prices = campaign.plan().parts[part.part].gradient_prices;
  std::stable_partition(prices.begin(), prices.end(), [&](const std::string& price) {
    return price == part.usual.gradient_price;
  });
  if (prices.size() < 2) return;
  std::vector<std::string> families;  // in the order of the problems
  std::map<std::string, std::vector<Setting>> settings;
  for (const std::string& price : prices) {
    Conditions conditions = part.usual;
    conditions.gradient_price = price;
    const Comparison comparison = comparison_of(campaign, results, conditions);
    for (const Group& group : groups_of(comparison)) {
      std::vector<Rating> ratings = rated(comparison, group.problems);
      Order order = order_of(ratings);
      if (!settings.contains(group.family)) families.push_back(group.family);
      settings[group.family].push_back(
          {price, std::move(ratings), std::move(order), group.problems.size()});
    }
  }
  for (const std::string& family : families) {
    add_rows(rows, part.families.at(family), "price of a gradient", settings[family]);
  }
}

/// The smoothing parameters of the surrogates that are used, the default one first.
std::vector<double> smoothings_of(const Comparison& comparison, const Group& group,
                                  bool penalised) {
  std::set<double> found;
  for (const CellResult& result : comparison.results) {
    const Formulation& formulation = result.cell->formulation;
    if (!group.has(result)) continue;
    if (formulation.smoothing > 0 && formulation.penalised == penalised)
      found.insert(formulation.smoothing);
  }
  std::vector<double> smoothings(found.begin(), found.end());
  const double usual = comparison.campaign->problems()[group.problems.front()].smoothing;
  std::stable_partition(smoothings.begin(), smoothings.end(), [&](double w) { return w == usual; });
  return smoothings;
}

void add_smoothings(Json& rows, const Comparison& comparison, const Group& group) {
  for (const bool penalised : {false, true}) {
    std::vector<Setting> settings;
    const std::vector<double> smoothings = smoothings_of(comparison, group, penalised);
    if (smoothings.size() < 2) continue;
    for (const double smoothing : smoothings) {
      Comparison shown = comparison;
      const Formulation formulation{smoothing, penalised};
      std::erase_if(shown.results,
                    [&](const CellResult& r) { return r.cell->formulation != formulation; });
      std::vector<Rating> ratings = rated(shown, group.problems);
      Order order = order_in(ratings, ratings.front().formulation);
      settings.push_back({fmt::format("{}", smoothing), std::move(ratings), std::move(order),
                          group.problems.size()});
    }
    add_rows(rows, group.family,
             penalised ? "smoothing of the penalised surrogate" : "smoothing of the surrogate",
             settings);
  }
}

void add_levels(Json& rows, const Comparison& comparison, const Group& group) {
  std::map<std::string, std::map<double, std::vector<std::size_t>>> factors;
  for (const std::size_t q : group.problems) {
    for (const auto& [name, level] : comparison.campaign->problems()[q].factors) {
      factors[name][level].push_back(q);
    }
  }
  for (const auto& [name, levels] : factors) {
    if (levels.size() < 2) continue;
    std::vector<Setting> settings;
    for (const auto& [level, problems] : levels) {
      std::vector<Rating> ratings = rated(comparison, problems);
      Order order = order_of(ratings);
      settings.push_back(
          {level_name(name, level), std::move(ratings), std::move(order), problems.size()});
    }
    add_rows(rows, group.family, name, settings);
  }
}

}  // namespace

Json change_data(const Campaign& campaign, const std::vector<CellResult>& results,
                 const std::vector<ReportedPart>& parts) {
  Json rows = Json::array();
  for (const ReportedPart& part : parts) {
    add_prices(rows, campaign, results, part);
    const Comparison comparison = comparison_of(campaign, results, part.usual);
    const bool of_grid = !campaign.plan().parts[part.part].machines.around.empty();
    for (Group group : groups_of(comparison)) {
      group.family = part.families.at(group.family);
      add_smoothings(rows, comparison, group);
      if (of_grid) add_levels(rows, comparison, group);
    }
  }
  return rows;
}

}  // namespace ricochet::studies::comparison
