#pragma once

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/report/table.h"
#include "tests/support/campaigns.h"

namespace ricochet::studies::comparison {

/// A run of 100 evaluations and 2 s that evaluated a solving point after so many, 0.01 s each, or
/// none, and returned it or not.
inline Outcome run_of(std::optional<std::int64_t> after, bool returned = true) {
  Outcome outcome;
  outcome.evaluations = 100;
  outcome.seconds = 2;
  outcome.verdict.solved = after.has_value();
  outcome.verdict.returned_solved = after && returned;
  outcome.verdict.evaluations_to_solve = after;
  if (after) outcome.verdict.seconds_to_solve = 0.01 * static_cast<double>(*after);
  outcome.verdict.optimality_gap = after ? 0.0 : 1.0;
  outcome.verdict.returned_optimality_gap = outcome.verdict.returned_solved ? 0.0 : 1.0;
  outcome.steps = {{after.value_or(50), 0.1, *outcome.verdict.optimality_gap}};
  return outcome;
}

/// Two runs alike.
inline std::vector<Outcome> twice(const Outcome& outcome) {
  return {outcome, outcome};
}

/// The runs of each cell of a campaign, in place of such that are made.
using RunsOf = std::function<std::vector<Outcome>(const PlannedCell& cell)>;

struct MadeUp {
  MadeUp(const std::string& plan, const RunsOf& runs_of,
         const Catalogue& catalogue = made_up_catalogue())
      : MadeUp(made_up_campaign(plan, catalogue), runs_of) {}

  MadeUp(Campaign its_campaign, const RunsOf& runs_of)
      : campaign(std::move(its_campaign)), reported(reported_parts(campaign)) {
    for (const PlannedCell& cell : campaign.cells()) {
      const Problem& problem = campaign.problems()[cell.problem];
      results.push_back(
          {&cell, runs_of(cell), std::make_shared<const Targets>(targets_of(problem))});
    }
  }
  MadeUp(const MadeUp&) = delete;
  MadeUp& operator=(const MadeUp&) = delete;

  std::vector<RatedPart> rated() const { return rated_parts(campaign, results, reported); }
  std::vector<EntrySet> sets() const { return entry_sets_of(campaign, results, reported); }

  Campaign campaign;
  std::vector<CellResult> results;
  std::vector<ReportedPart> reported;
};

/// The made-up catalogue with so many bowls of one variable, "bowl-1" and so on, and these solvers.
inline Catalogue bowls_and(int bowls, const std::vector<std::string>& solvers) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.families = {{"bowl", {}}};
  for (int k = 1; k <= bowls; ++k) {
    catalogue.families[0].problems.push_back(bowl("bowl-" + std::to_string(k), 1));
  }
  catalogue.solvers.clear();
  for (const std::string& name : solvers) catalogue.solvers.push_back(chance(name));
  return catalogue;
}

/// A part with two runs in each cell.
inline std::string two_runs(const std::string& problems, const std::string& solvers = "*",
                            const std::string& more = "") {
  return part_of(problems, "solvers = \"" + solvers + "\"\nbudgets = 100\ninstances = 2\n" + more);
}

constexpr const char* both_bowls = R"(["bowl-1", "bowl-2"])";

/// The rows of a table in these columns, which are given with commas between: "a | 0.5 | yes", and
/// "-" for what is missing. Numbers have all their digits.
inline std::vector<std::string> rows_of(const Table& table, const std::string& columns) {
  std::vector<std::string> rows;
  each_row(table, [&](const Row& row) {
    std::string& text = rows.emplace_back();
    for (const Column& column : columns_named(columns)) {
      const Value& value = row[column.name];
      const double* number = std::get_if<double>(&value);
      if (!text.empty()) text += " | ";
      text += is_missing(value) ? "-" : number ? fmt::format("{}", *number) : text_of(value);
    }
  });
  return rows;
}

}  // namespace ricochet::studies::comparison
