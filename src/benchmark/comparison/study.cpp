#include "src/benchmark/comparison/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "ricochet/solvers.h"
#include "src/benchmark/analysis/comparison.h"
#include "src/benchmark/comparison/answers.h"
#include "src/benchmark/comparison/beaten_data.h"
#include "src/benchmark/comparison/break_even_data.h"
#include "src/benchmark/comparison/change_data.h"
#include "src/benchmark/comparison/entry_set.h"
#include "src/benchmark/comparison/factor_data.h"
#include "src/benchmark/comparison/failure_data.h"
#include "src/benchmark/comparison/formulation_data.h"
#include "src/benchmark/comparison/group.h"
#include "src/benchmark/comparison/held_out_data.h"
#include "src/benchmark/comparison/lacking_data.h"
#include "src/benchmark/comparison/leader_data.h"
#include "src/benchmark/comparison/log_ratio_data.h"
#include "src/benchmark/comparison/machine_data.h"
#include "src/benchmark/comparison/opening.h"
#include "src/benchmark/comparison/order_data.h"
#include "src/benchmark/comparison/own_solver_data.h"
#include "src/benchmark/comparison/pages.h"
#include "src/benchmark/comparison/pair_data.h"
#include "src/benchmark/comparison/perturbation_data.h"
#include "src/benchmark/comparison/profile_data.h"
#include "src/benchmark/comparison/relocated_optimum_data.h"
#include "src/benchmark/comparison/reported_part.h"
#include "src/benchmark/comparison/separation_data.h"
#include "src/benchmark/comparison/share_data.h"
#include "src/benchmark/comparison/solver_facts.h"
#include "src/benchmark/comparison/solver_pages.h"
#include "src/benchmark/comparison/speed_accuracy_data.h"
#include "src/benchmark/comparison/view_data.h"
#include "src/benchmark/experiment/campaign/archived_campaign.h"
#include "src/benchmark/experiment/store/stored_parts.h"
#include "src/core/suite_version.h"

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
