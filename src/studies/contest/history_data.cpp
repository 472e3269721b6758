#include "src/studies/contest/history_data.h"

#include <algorithm>
#include <map>
#include <utility>

#include "embedded/old_contest.h"
#include "src/statistics/wilson_interval.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

struct Tally {
  int solved = 0;
  int runs = 0;

  double share() const { return solved / static_cast<double>(runs); }
};

/// Those of every solver and form, with the largest budget.
std::map<std::string, std::map<std::string, Tally>> tallies_of(
    const Plan& plan, const std::vector<Standing>& standings, const Group& group) {
  std::map<std::string, std::map<std::string, Tally>> tallies;
  for (const Standing& s : standings) {
    const auto& mine = group.questions;
    if (s.budget + 1 != plan.budgets.size()) continue;
    if (std::find(mine.begin(), mine.end(), s.question) == mine.end()) continue;
    Tally& tally = tallies[s.solver][plan.questions[s.question].name_of(s.form)];
    for (const Outcome& outcome : s.outcomes) {
      ++tally.runs;
      tally.solved += outcome.verdict.solved ? 1 : 0;
    }
  }
  return tallies;
}

Json share_of(int solved, int runs) {
  const Interval interval = wilson_interval(solved, runs);
  return {{"share", solved / static_cast<double>(runs)},
          {"lower", interval.lower},
          {"upper", interval.upper}};
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

Json history_data(const Plan& plan, const std::vector<Standing>& standings,
                  const std::vector<Group>& groups) {
  const Json old = Json::parse(embedded::old_contest);
  Json all = Json::array();
  for (const Group& group : groups) {
    auto tallies = tallies_of(plan, standings, group);
    Json rows = Json::array();
    for (const Json& then : old) {
      const std::string solver = name_now(then["solver"].get<std::string>());
      if (then["family"] != group.family || !tallies.contains(solver)) continue;
      const auto& forms = tallies[solver];
      const auto same = forms.find(then["form"].get<std::string>());
      if (same == forms.end()) continue;
      const auto best = std::max_element(
          forms.begin(), forms.end(),
          [](const auto& a, const auto& b) { return a.second.share() < b.second.share(); });
      rows.push_back({{"family", group.family},
                      {"solver", solver},
                      {"form", then["form"]},
                      {"then", share_of(then["solved"].get<int>(), then["runs"].get<int>())},
                      {"evaluations_then", then["evaluations"]},
                      {"now", share_of(same->second.solved, same->second.runs)},
                      {"best_form", best->first},
                      {"best", share_of(best->second.solved, best->second.runs)}});
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
