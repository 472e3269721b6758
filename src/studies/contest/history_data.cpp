#include "src/studies/contest/history_data.h"

#include <algorithm>
#include <utility>

#include "embedded/old_contest.h"
#include "src/studies/contest/share_data.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

double share_of(const Share& share) {
  return share.successes / static_cast<double>(share.trials);
}

/// The old name, and the one that the same solver has now.
std::string name_now(const std::string& old) {
  if (old == "ipopt" || old == "continuation-ipopt") return old + "-tuned";
  return old;
}

/// Puts the place of every row by the share under `key` into `place`; equals share the best one.
void add_places(Json& rows, const char* key, const char* place) {
  for (Json& row : rows) {
    int before = 0;
    for (const Json& other : rows) {
      before += other[key]["share"].get<double>() > row[key]["share"].get<double>() ? 1 : 0;
    }
    row[place] = before + 1;
  }
}

}  // namespace

Json history_data(const ContestPlan& plan, const std::vector<Standing>& standings,
                  const std::vector<Group>& groups) {
  const Json old = Json::parse(embedded::old_contest);
  Json all = Json::array();
  for (const Group& group : groups) {
    auto shares = shares_by_form(plan, standings, group);
    Json rows = Json::array();
    for (const Json& then : old) {
      const std::string solver = name_now(then["solver"].get<std::string>());
      if (then["family"] != group.family || !shares.contains(solver)) continue;
      const auto& forms = shares[solver];
      const auto same = forms.find(then["form"].get<std::string>());
      if (same == forms.end()) continue;
      const auto best = std::max_element(
          forms.begin(), forms.end(),
          [](const auto& a, const auto& b) { return share_of(a.second) < share_of(b.second); });
      rows.push_back({{"family", group.family},
                      {"solver", solver},
                      {"form", then["form"]},
                      {"then", share_data({then["solved"].get<int>(), then["runs"].get<int>()})},
                      {"evaluations_then", then["evaluations"]},
                      {"now", share_data(same->second)},
                      {"best_form", best->first},
                      {"best", share_data(best->second)}});
    }
    add_places(rows, "then", "place_then");
    add_places(rows, "best", "place_now");
    std::stable_sort(rows.begin(), rows.end(), [](const Json& a, const Json& b) {
      return a["place_then"].get<int>() < b["place_then"].get<int>();
    });
    for (Json& row : rows) all.push_back(std::move(row));
  }
  return all;
}

}  // namespace ricochet::studies::contest
