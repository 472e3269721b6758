#include "src/analysis/comparison/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "ricochet/solver.h"
#include "src/analysis/comparison/family.h"
#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/leaders.h"
#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "src/analysis/comparison/solver_pages.h"
#include "src/analysis/comparison/view.h"
#include "src/analysis/results.h"
#include "src/core/instance.h"
#include "src/experiment/archived_campaign.h"
#include "src/experiment/merge.h"

namespace ricochet::studies::comparison {

namespace {

using report::Chart;
using report::Json;
using report::Results;

/// The plan, part by part.
Table plan_table(const Campaign& campaign, const std::vector<RatedPart>& parts) {
  Table table{"plan",
              {{"part"},
               {"problems"},
               {"variables"},
               {"budgets", "evaluations a variable"},
               {"instances"},
               {"results", "combinations of problem, entry and setting"}}};
  for (const RatedPart& rated : parts) {
    const std::vector<std::size_t> problems = rated.comparison.problems();
    const PlanPart& asked = *rated.comparison.part;
    if (problems.empty()) continue;
    table.add(name_of_part(asked, rated.part->part), problems.size(),
              variables_of(campaign, problems), fmt::format("{}", fmt::join(asked.budgets, ", ")),
              asked.instances, rated.comparison.results.size());
  }
  return table;
}

/// The share of runs that each solver solved in each family with the largest budget, in its best
/// formulation: a column for each family, missing where it takes none of its problems; sorted by
/// the number of families taken, then by the sum of the shares.
Table solver_map(const Table& speed_accuracy, const Table& leaders) {
  const Table families = where(leaders, "largest", true);
  const Table largest = where(speed_accuracy, [&](const Row& row) {
    return row.is("largest") &&
           families.find([&](const Row& family) { return family["family"] == row["family"]; });
  });
  Table table = only(sorted(aggregated(sorted(largest, {"solver"}), {"solver"},
                                       {{{"taken"}, "", count_of}, {{"sum"}, "share", sum_of}}),
                            {"-taken", "-sum"}),
                     {"solver"});
  table.name = "map";
  each_row(families, [&](const Row& family) {
    const Table own = where(largest, "family", family["family"]);
    table = with(std::move(table), {family.text("family"), "", ".0%", 3}, [&](const Row& row) {
      const auto share =
          own.find([&](const Row& other) { return other["solver"] == row["solver"]; });
      return share ? (*share)["share"] : Value();
    });
  });
  return table;
}

Chart map_chart(const Table& map) {
  Chart chart{.name = "map",
              .x = {"family"},
              .y = {""},
              .heat_map = report::HeatMap{"success rate [%]", {}, report::Range{0, 100}},
              .width = 900};
  for (std::size_t k = 1; k < map.columns.size(); ++k) {
    chart.x.categories.push_back(map.columns[k].name);
    chart.heat_map->column_links.push_back("&family=" + map.columns[k].name);
  }
  std::size_t half = 0;  // solvers that solve half of the runs of some family
  for (std::size_t i = map.rows.size(); i-- > 0;) {  // from the bottom
    const std::string solver = map[i].text("solver");
    chart.y.categories.push_back(solver);
    chart.heat_map->row_links.push_back("view#entry=" + solver);
    auto& cells = chart.heat_map->rows.emplace_back();
    double most = 0;
    for (std::size_t k = 1; k < map.columns.size(); ++k) {
      const auto share = number_in(map.rows[i][k]);
      cells.push_back(share ? std::optional(100 * *share) : std::nullopt);
      most = std::max(most, share.value_or(0));
    }
    half += most >= 0.5 ? 1 : 0;
  }
  chart.title = fmt::format("{} of {} solvers solve half of the runs of some family or more", half,
                            map.rows.size());
  chart.height = 150 + 16 * static_cast<int>(map.rows.size());
  chart.description = "Heat map of the success rate over family and solver.";
  return chart;
}

/// The names of the problems that tell nothing: for each family those that random search solves at
/// once, and those that nobody solved.
Table by_family(const Table& silent) {
  const auto names = [](const std::vector<Value>& values) {
    std::string text;
    for (const Value& value : values) text += (text.empty() ? "" : ", ") + text_of(value);
    return value_of(text);
  };
  const Table told = with(silent, {"why"}, [](const Row& row) {
    return value_of(row.is("unsolved") ? "solved by nobody" : "solved by random search at once");
  });
  Table table = aggregated(told, {"family", "why"},
                           {{{"number"}, "", count_of}, {{"names", "problems"}, "problem", names}});
  table.name = "silent-names";
  return table;
}

/// Speed against accuracy of all families together, or of each if none are joined.
void add_fronts(const Table& speed_accuracy, Results& page) {
  const Table joint = where(speed_accuracy, "family", std::string("all"));
  page.set("paper-algorithm",
           joint.rows.empty() ? Value() : value_of(paper_algorithm_sentence(joint)));
  page.add(joint.rows.empty() ? Table{"kinds"} : kind_table(joint));
  page.set("fronts", joint.rows.empty() ? Value() : value_of(front_sentence(joint)));
  if (!joint.rows.empty()) {
    page.add(speed_accuracy_chart(joint, false));
    page.add(speed_accuracy_chart(joint, true));
  }
}

std::optional<std::string> lacking_sentence(const Campaign& campaign) {
  std::vector<std::string> names;
  for (const MissingSolver& one : lacking(campaign.plan(), missing_solvers())) {
    names.push_back(fmt::format("{} ({})", one.solver, one.library));
  }
  if (names.empty()) return {};
  return fmt::format(
      "This build lacks solvers of the suite that the plan asks for: {}. On a family where one of "
      "them is best, another is named first.",
      fmt::join(names, ", "));
}

Json page_json(const char* kind, const Results& results) {
  Json json = {{"report", kind}};
  json.update(json_of(results));
  return json;
}

Json compute(const Campaign& campaign, const Store& store) {
  Digest digest(store.description());
  const std::vector<CellResult> all =
      cell_results(campaign, store, [&](const StoredRun& run) { digest.add(run.key, run.record); });
  std::vector<CellResult> results = all;
  std::vector<ReportedPart> reported = reported_parts(campaign);
  set_pathological_apart(campaign, results, reported);
  set_silent(campaign, results, reported);
  const std::vector<RatedPart> parts = rated_parts(campaign, results, reported);
  const std::vector<EntrySet> sets = entry_sets_of(campaign, results, reported);
  const Table speed_accuracy = speed_accuracy_table(campaign, sets);
  const Table leaders = leader_table(parts);
  std::map<std::string, std::string> hashes;
  for (const StoredProblem& problem : store.description().problems) {
    hashes[problem.name] = problem.hash;
  }

  const std::string name = campaign.plan().name;
  const bool compared = name.starts_with("compare");  // by the command `compare`
  Results page;
  std::string finding = foreign_runs_of(store.description());
  if (!finding.empty()) finding += ' ';
  const Table beaten = beaten_table(campaign, results);
  if (!beaten.rows.empty()) finding += "An error: best known values of some problems were beaten. ";
  page.set("finding", finding + opening_of(leaders));
  page.set("campaign", name);
  page.set("made_by", compared ? Value() : value_of("./ricochet run " + name));
  page.set("runs", campaign.runs());  // cell_results() throws where runs are missing
  page.set("problems", campaign.problems().size());
  page.set("solvers", campaign.solvers().size());
  page.set("digest", digest.text());
  page.set("suite", suite_version);
  page.set("lacking", lacking_sentence(campaign));
  page.add(Table(leaders));
  page.add(subset_table(parts));
  page.add(coverage_table(parts));
  page.add(silent_table(campaign, results, reported));
  page.add(by_family(page.tables.back()));
  add_fronts(speed_accuracy, page);
  const Table map = solver_map(speed_accuracy, leaders);
  if (map.rows.size() > 1) page.add(map_chart(map));
  page.add(Table(map));
  page.add(order_table(results, parts));
  page.add(summary_of(page.tables.back(), "order-summary", {"changed"}));
  page.add(held_out_table(parts));
  page.add(change_table(campaign, results, parts));
  page.add(summary_of(page.tables.back(), "change-summary", {"family", "changed"}));
  add_own_solvers(campaign, sets, all_solvers(), page);
  add_relocated_optima(campaign, results, page);
  page.add(failure_table(parts));
  page.add(Table(beaten));
  page.add(plan_table(campaign, parts));
  page.add(library_notes(campaign.solvers()));
  page.add(Table(speed_accuracy));

  Json data = json_of(page);
  Json& pages = data["pages"] = Json::array();
  const auto add = [&](const std::string& folder, const char* kind, const Results& of) {
    pages.push_back({{"folder", folder}, {"data", page_json(kind, of)}});
  };
  for (const FamilyPage& family :
       family_pages(campaign, parts, sets, leaders, speed_accuracy, hashes)) {
    add(family.folder, "comparison_family", family.results);
  }
  const Results across = machines_page(parts);
  if (!across.parts.empty()) add("across-machines", "comparison_machines", across);
  Results failures;
  const bool perturbed = add_perturbations(campaign, results, failures);
  if (add_pathological(campaign, all, failures) || perturbed) {
    if (!perturbed) {
      failures.add(Table{"perturbations"});
      failures.add(Table{"outcomes"});
      failures.set("perturbed-runs", Value());
      failures.set("finding", *failures.value("pathological-runs"));
    }
    add("robustness", "comparison_failures", failures);
  }
  add("solvers", "comparison_solvers",
      solvers_page(campaign, results, sets, speed_accuracy, leaders));
  Results view = view_page(campaign, results, reported, sets, all_solvers());
  view.set("runs", campaign.runs());
  view.set("campaign", name);
  view.set("command",
           compared ? "./ricochet compare" : fmt::format("./ricochet run {} --out mine", name));
  add("view", "comparison_view", view);
  return data;
}

}  // namespace

}  // namespace ricochet::studies::comparison

namespace ricochet::studies {

Study comparison_study(const Campaign& campaign, const Store& store) {
  return {"comparison", "Fewer instances and evaluations",
          [&campaign, &store](bool) { return comparison::compute(campaign, store); }};
}

}  // namespace ricochet::studies
