#include "src/benchmark/comparison/pages.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// Lists whose rows name their family and belong on its page.
constexpr const char* of_a_family[] = {
    "speed_accuracy_charts", "profile_families", "pair_families", "log_ratio_families",
    "break_even_families",   "formulations",     "ceilings"};

Json rows_of(const Json& all, const std::string& family) {
  Json rows = Json::array();
  for (const Json& row : all) {
    if (row.at("family") == family) rows.push_back(row);
  }
  return rows;
}

/// Moves members of one object to another.
Json taken(Json& from, std::initializer_list<const char*> keys) {
  Json to = Json::object();
  for (const char* key : keys) {
    to[key] = std::move(from.at(key));
    from.erase(key);
  }
  return to;
}

/// Returns a row for each solver with the share of runs solved in each family with the largest
/// budget, in its best formulation; sorted by the number of families taken, then by the share
/// solved.
Json solver_map(const Json& speed_accuracy, const Json& families) {
  std::map<std::string, Json> shares;
  for (const Json& row : speed_accuracy) {
    if (row.at("budget").is_null() || !row.at("largest").get<bool>()) continue;
    for (std::size_t f = 0; f < families.size(); ++f) {
      if (families[f].at("family") != row.at("family")) continue;
      Json& mine = shares[row.at("solver")];
      if (mine.is_null()) mine = Json(families.size(), Json());
      mine[f] = row.at("share");
    }
  }
  struct Row {
    std::string solver;
    Json shares;
    std::size_t taken = 0;
    double sum = 0;
  };
  std::vector<Row> order;
  for (auto& [solver, row] : shares) {
    Row& mine = order.emplace_back(Row{solver, std::move(row)});
    for (const Json& share : mine.shares) {
      if (share.is_null()) continue;
      ++mine.taken;
      mine.sum += share.get<double>();
    }
  }
  std::stable_sort(order.begin(), order.end(), [](const Row& a, const Row& b) {
    return std::pair(a.taken, a.sum) > std::pair(b.taken, b.sum);
  });
  Json rows = Json::array();
  for (Row& row : order) {
    rows.push_back({{"solver", row.solver}, {"shares", std::move(row.shares)}});
  }
  return rows;
}

/// Returns how many solvers solve most of some family; nothing if one is the only one in all.
Json map_leaders(const Json& map, std::size_t families) {
  std::set<std::string> leaders;
  for (std::size_t f = 0; f < families; ++f) {
    double most = 0;
    std::string leader;
    for (const Json& row : map) {
      const Json& share = row.at("shares").at(f);
      if (share.is_null() || share.get<double>() <= most) continue;
      most = share.get<double>();
      leader = row.at("solver").get<std::string>();
    }
    if (!leader.empty()) leaders.insert(leader);
  }
  return leaders.size() > 1 ? Json(leaders.size()) : Json();
}

}  // namespace

Json in_pages(Json all) {
  Json pages = Json::array();
  Json families = Json::array();
  for (Json& group : all["groups"]) {
    const std::string family = group["family"];
    Json leader = group["budgets"].back()["leader"];
    families.push_back({{"family", family},
                        {"budget", group["budgets"].back()["budget"]},
                        {"problems", group["problems"].size()},
                        {"leader", std::move(leader)}});
    Json page = std::move(group);
    page["report"] = "comparison_family";
    for (const char* key : {"drawn", "ratings"}) page.erase(key);  // the last budget has the same
    for (const char* key : of_a_family) page[key] = rows_of(all[key], family);
    pages.push_back({{"folder", family}, {"data", std::move(page)}});
  }
  all.erase("groups");
  all["map"] = solver_map(all["speed_accuracy"], families);
  all["map_leaders"] = map_leaders(all["map"], families.size());
  all["families"] = std::move(families);
  for (const char* key : of_a_family) {
    if (key == std::string("speed_accuracy_charts")) continue;
    all.erase(key);
  }
  // Charts of single families are also on their own pages; they stand here only if there is no
  // joint one.
  const Json joint = rows_of(all["speed_accuracy_charts"], "all");
  if (!joint.empty()) all["speed_accuracy_charts"] = joint;
  Json machines = taken(all, {"machines", "machine_maps", "landscapes", "turns", "effects",
                              "unsure_effects", "main_effects"});
  if (!machines["machines"].empty() || !machines["turns"].empty()) {
    machines["report"] = "comparison_machines";
    pages.push_back({{"folder", "across-machines"}, {"data", std::move(machines)}});
  }
  Json failures = taken(
      all, {"perturbations", "perturbation_names", "perturbation_rows", "atlas", "atlas_maps"});
  if (!failures["perturbations"].empty()) {
    failures["report"] = "comparison_failures";
    pages.push_back({{"folder", "failure-atlas"}, {"data", std::move(failures)}});
  }
  all["pages"] = std::move(pages);
  return all;
}

}  // namespace ricochet::studies::comparison
