#include "src/analysis/comparison/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "ricochet/solver.h"
#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/pairs.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "src/analysis/comparison/solver_pages.h"
#include "src/analysis/comparison/view.h"
#include "src/analysis/results.h"
#include "src/core/instance.h"
#include "src/experiment/archived_campaign.h"
#include "src/experiment/merge.h"

namespace ricochet::studies {

namespace {

using namespace comparison;
using report::Json;

/// The results of one part: lists.
Json results_of(const Campaign& campaign, const std::vector<CellResult>& results,
                const ReportedPart& part) {
  const Comparison comparison = comparison_of(campaign, results, part.usual);
  const std::vector<std::size_t> problems = comparison.problems();
  const PlanPart& asked = *comparison.part;
  std::vector<Group> groups = groups_of(comparison);
  std::erase_if(groups,
                [&](const Group& group) { return part.asked_again.contains(group.family); });
  for (Group& group : groups) group.family = part.families.at(group.family);
  const Ratings ratings = ratings_of(comparison, groups);
  Json group_rows = group_data(comparison, groups, ratings);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t k = 0; k < groups[g].problems.size(); ++k) {
      group_rows[g]["problems"][k].update(separation_data(comparison, groups[g].problems[k]));
    }
  }
  Json plan = variables_of(campaign, problems);
  plan.update({{"problems", problems.size()},
               {"least", asked.budgets.front()},
               {"most", asked.budgets.back()},
               {"two_budgets", asked.budgets.size() > 1},
               {"instances", asked.instances},
               {"results", comparison.results.size()}});
  return {{"plans", Json::array({plan})},
          {"leaders", leader_data(comparison, groups, group_rows)},
          {"groups", group_rows},
          {"formulations", formulation_data(comparison, groups)},
          {"ceilings", ceiling_data(comparison, groups)},
          {"orders", order_data(comparison, results, part, groups, ratings)},
          {"held_out", held_out_data(comparison, groups)},
          {"failures", failure_data(comparison)}};
}

/// Adds to the problems of the groups the hashes that the store has of them.
void add_hashes(const std::vector<StoredProblem>& problems, Json& groups) {
  std::map<std::string, std::string> hashes;
  for (const StoredProblem& problem : problems) hashes[problem.name] = problem.hash;
  for (Json& group : groups) {
    for (Json& row : group["problems"]) row["hash"] = hashes.at(row["problem"]);
  }
}

/// Adds to the groups what is to be known of the libraries of their entries.
void add_notes(const std::vector<Solver>& solvers, Json& groups) {
  for (Json& group : groups) {
    std::vector<Solver> mine;
    for (const Solver& solver : solvers) {
      const bool rated = std::ranges::any_of(
          group["ratings"], [&](const Json& rating) { return rating["solver"] == solver.name; });
      if (rated) mine.push_back(solver);
    }
    group["library_notes"] = library_notes(mine);
  }
}

Json compute(const Campaign& campaign, const Store& store) {
  Digest digest(store.description());
  const std::vector<CellResult> results =
      cell_results(campaign, store, [&](const StoredRun& run) { digest.add(run.key, run.record); });
  const std::vector<ReportedPart> parts = reported_parts(campaign);
  Json data;
  for (const char* key : {"plans", "leaders", "groups", "formulations", "ceilings", "orders",
                          "held_out", "failures"}) {
    data[key] = Json::array();
  }
  for (const ReportedPart& part : parts) {
    Json of_part = results_of(campaign, results, part);
    for (auto& [key, rows] : of_part.items()) {
      for (Json& row : rows) data[key].push_back(std::move(row));
    }
  }
  data.update(relocated_optimum_data(campaign, results));
  const std::vector<EntrySet> sets = entry_sets_of(campaign, results, parts);
  data.update(speed_accuracy_data(campaign, sets));
  data["profile_families"] = profile_data(campaign, sets);
  data["pair_families"] = pair_data(campaign, sets);
  data["log_ratio_families"] = log_ratio_data(campaign, sets);
  data["break_even_families"] = break_even_data(campaign, sets);
  data.update(perturbation_data(campaign, results));
  data.update(factor_data(campaign, results, parts));
  data.update(machine_data(campaign, results, parts));
  data.update(own_solver_data(campaign, sets, all_solvers()));
  data["beaten"] = beaten_data(campaign, results);
  data["changes"] = change_data(campaign, results, parts);
  Json solvers = Json::array();
  const std::vector<Solver> known = all_solvers();
  for (const Solver& solver : campaign.solvers()) {
    const bool outside = std::none_of(known.begin(), known.end(),
                                      [&](const Solver& k) { return k.name == solver.name; });
    solvers.push_back({{"name", solver.name},
                       {"version", solver.version},
                       {"outside", outside},
                       {"kind", kind_of(solver.name)},
                       {"needs", solver.capabilities.needs_in_words()}});
  }
  data["campaign"] = campaign.plan().name;
  data["compared"] = campaign.plan().name.starts_with("compare");  // true for the command `compare`
  data["runs"] = campaign.runs();
  data["planned"] = campaign.runs();  // cell_results() throws where runs are missing
  data["present"] = campaign.runs();
  data["missing"] = 0;
  data["digest"] = digest.text();
  data["suite"] = suite_version;
  data["lacking"] = lacking_data(campaign.plan(), missing_solvers());
  data["solvers"] = std::move(solvers);
  data["library_notes"] = library_notes(campaign.solvers());
  add_hashes(store.description().problems, data["groups"]);
  add_notes(campaign.solvers(), data["groups"]);
  Json solvers_data = solvers_page(campaign, results, sets, data["speed_accuracy"]);
  Json view = {{"report", "comparison_view"},
               {"campaign", data["campaign"]},
               {"compared", data["compared"]},
               {"runs", data["runs"]}};
  view.update(view_data(campaign, results, parts, sets, known));
  view["view"]["command"] = data["compared"].get<bool>()
                                ? "./ricochet compare"
                                : fmt::format("./ricochet run {} --out mine", campaign.plan().name);
  data = in_pages(std::move(data));
  data["answers"] = answers_data(data);
  std::string opening = foreign_runs_of(store.description());
  if (!opening.empty()) opening += ' ';
  data["opening"] = opening + opening_of(data["leaders"]);
  data["pages"].push_back({{"folder", "solvers"}, {"data", std::move(solvers_data)}});
  data["pages"].push_back({{"folder", "view"}, {"data", std::move(view)}});
  return data;
}

}  // namespace

Study comparison_study(const Campaign& campaign, const Store& store) {
  return {"comparison", "Fewer instances and evaluations",
          [&campaign, &store](bool) { return compute(campaign, store); }};
}

}  // namespace ricochet::studies

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
