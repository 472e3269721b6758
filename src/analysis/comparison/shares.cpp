#include "src/analysis/comparison/shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace ricochet::studies::comparison {

std::string kind_of_end(const Outcome& outcome, std::int64_t budget) {
  if (outcome.solved()) return "solved";
  if (!outcome.failure.empty()) {
    const bool ended = outcome.failure.starts_with("crashed") ||
                       outcome.failure.starts_with("killed") ||
                       outcome.failure.starts_with("ended the process");
    return ended ? "killed or crashed" : "threw";
  }
  if (outcome.verdict.solved) return "evaluated, not returned";
  if (!outcome.verdict.feasible) return "nothing feasible";
  return outcome.evaluations < budget ? "gave up early" : "budget spent";
}

Table failure_table(const std::vector<RatedPart>& parts) {
  Table table{"failures",
              {{"solver"},
               {"problem"},
               {"formulation"},
               {"what", "what happened"},
               {"times", "failed"},
               {"runs"},
               {"command"}}};
  for (const RatedPart& part : parts) {
    for (const CellResult& result : part.comparison.results) {
      const Cell& cell = result.cell->cell;
      // The number of failures, and the first instance with one.
      std::map<std::string, std::pair<int, int>> failures;
      for (const Outcome& outcome : result.outcomes) {
        if (outcome.failure.empty()) continue;
        ++failures.try_emplace(outcome.failure, 0, outcome.instance).first->second.first;
      }
      for (const auto& [what, times] : failures) {
        table.add(cell.solver, cell.problem, cell.formulation, what, times.first,
                  result.outcomes.size(),
                  fmt::format("ricochet solve '{}' {} --formulation {} --budget {} --instance {} "
                              "--seed {}",
                              cell.solver, cell.problem, cell.formulation,
                              result.cell->budget.evaluations, times.second, part.comparison.run));
      }
    }
  }
  return table;
}

Table formulation_table(const std::vector<Rating>& ratings) {
  Table entries{"entries", {{"formulation"}, {"solver"}, {"returned"}}};
  for (const Rating& r : ratings) entries.add(r.formulation, r.solver, r.returned);
  const Table taken = aggregated(entries, {"solver"}, {{{"formulations"}, "", count_of}});
  const Table several = where(joined(entries, taken, {"solver"}),
                              [](const Row& row) { return row.number("formulations") > 1; });
  const Table solving = where(several, [](const Row& row) { return row.number("returned") > 0; });
  const Table best = joined(aggregated(solving, {"solver"}, {{{"returned"}, "returned", most_of}}),
                            solving, {"solver", "returned"});
  Table table = aggregated(several, {"formulation"},
                           {{{"solvers"}, "", count_of},
                            {{"mean", "success rate, mean [%]", ".0%", 3}, "returned", mean_of},
                            {{"most", "at most [%]", ".0%", 3}, "returned", most_of}});
  table.name = "formulations";
  table = with(std::move(table), {"best", "best formulation of"}, [&](const Row& row) {
    return value_of(where(best, "formulation", row["formulation"]).rows.size());
  });
  return sorted(std::move(table), {"-mean"});
}

Table ceiling_table(const Comparison& comparison, const Group& group) {
  Table table{"surrogate-bias",
              {{"problem"},
               {"smoothing"},
               {"optimum", "surrogate's optimum", ".3f"},
               {"best", "best point", ".3f"},
               {"distance", "off by", ".3f"},
               {"optimality_gap", "optimality gap", ".3g"},
               {"solves", "solves it", "mark"}}};
  for (const std::size_t q : group.problems) {
    const Problem& problem = comparison.campaign->problems()[q];
    for (const Formulation& formulation : problem.formulations(comparison.part->smoothings)) {
      if (formulation.smoothing == 0 || formulation.penalised) continue;
      const auto found = ceiling(problem, formulation.smoothing);
      if (!found) continue;
      table.add(problem.name, formulation.smoothing, found->optimum, (*problem.best_point)[0],
                found->distance, found->optimality_gap,
                found->optimality_gap && *found->optimality_gap <= problem.tolerance);
    }
  }
  return table;
}

void add_runs(Share& share, const CellResult& result) {
  for (const Outcome& outcome : result.outcomes) {
    ++share.trials;
    share.successes += outcome.solved() ? 1 : 0;
  }
}

std::string variables_of(const Campaign& campaign, const std::vector<std::size_t>& problems) {
  Eigen::Index least = campaign.problems()[problems.front()].dimension();
  Eigen::Index most = least;
  for (const std::size_t q : problems) {
    const Eigen::Index n = campaign.problems()[q].dimension();
    least = std::min(least, n);
    most = std::max(most, n);
  }
  return least == most ? fmt::format("{} variable{}", least, most > 1 ? "s" : "")
                       : fmt::format("{} to {} variables", least, most);
}

}  // namespace ricochet::studies::comparison
