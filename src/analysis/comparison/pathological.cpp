#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "src/analysis/comparison/sections.h"

namespace ricochet::studies::comparison {

namespace {

constexpr const char* endings[] = {"solved", "spent", "ended", "threw", "killed", "crashed"};

/// How a run on a pathological problem ended.
std::string ending_of(const Outcome& outcome, const Budget& budget, Eigen::Index variables) {
  const std::string& failure = outcome.failure;
  if (failure.starts_with("killed")) return "killed";
  if (failure.starts_with("crashed") || failure.starts_with("ended the process")) return "crashed";
  if (!failure.empty()) return "threw";
  if (outcome.solved()) return "solved";
  // A gradient that the budget does not allow is refused.
  const std::int64_t gradient = budget.gradient_price.value_or(variables);
  return outcome.evaluations + gradient >= budget.evaluations ? "spent" : "ended";
}

/// A row for each run on a pathological problem that is not disturbed, with the largest budget.
Table runs_of(const Campaign& campaign, const std::vector<CellResult>& results) {
  Table runs{"runs", {{"problem"}, {"what", "what it is"}, {"solver"}, {"ending"}, {"found"}}};
  const auto largest = largest_budgets(results);
  for (const CellResult& result : results) {
    const PlannedCell& cell = *result.cell;
    const Problem& problem = campaign.problems()[cell.problem];
    const bool counts = problem.hazardous && cell.cell.perturbation == "plain" &&
                        cell.cell.budget == largest.at(cell.problem);
    if (!counts) continue;
    for (const Outcome& outcome : result.outcomes) {
      runs.add(problem.name, problem.source, cell.cell.solver,
               ending_of(outcome, cell.budget, problem.dimension()), outcome.verdict.solved);
    }
  }
  return runs;
}

int number_of(const std::vector<Value>& values, const Value& value) {
  return static_cast<int>(std::ranges::count(values, value));
}

/// Endings with their numbers, such as "2 solved, 1 spent".
Value endings_in_words(const std::vector<Value>& values) {
  std::vector<std::string> words;
  for (const std::string ending : endings) {
    if (const int runs = number_of(values, ending))
      words.push_back(fmt::format("{} {}", runs, ending));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

void set_pathological_apart(const Campaign& campaign, std::vector<CellResult>& results,
                            std::vector<ReportedPart>& parts) {
  const auto is_hazardous = [&](const CellResult& result) {
    return campaign.problems()[result.cell->problem].hazardous;
  };
  if (std::ranges::all_of(results, is_hazardous)) return;
  std::erase_if(results, is_hazardous);
  std::erase_if(parts, [&](const ReportedPart& part) {
    return std::ranges::none_of(results, [&](const CellResult& result) {
      return std::ranges::count(result.cell->parts, part.part) > 0;
    });
  });
}

bool add_pathological(const Campaign& campaign, const std::vector<CellResult>& results,
                      report::Results& page) {
  const Table runs = runs_of(campaign, results);
  std::vector<Aggregate> aggregates = {{{"runs"}, "", count_of}};
  for (const std::string ending : endings) {
    aggregates.push_back({{ending}, "ending", [ending](const std::vector<Value>& values) {
                            return value_of(number_of(values, ending));
                          }});
  }
  aggregates.push_back({{"found"}, "found", [](const std::vector<Value>& values) {
                          return value_of(number_of(values, true));
                        }});
  Table problems = aggregated(runs, {"problem", "what"}, aggregates);
  problems.name = "pathological";
  const Table cells =
      aggregated(runs, {"solver", "problem"}, {{{"endings"}, "ending", endings_in_words}});
  Table solvers{"pathological-solvers", {{"solver"}}};
  each_row(problems, [&](const Row& row) { solvers.columns.push_back({row.text("problem")}); });
  each_row(aggregated(cells, {"solver"}, {}), [&](const Row& solver) {
    std::vector<Value> row = {solver["solver"]};
    each_row(problems, [&](const Row& problem) {
      const auto cell = cells.find([&](const Row& one) {
        return one["solver"] == solver["solver"] && one["problem"] == problem["problem"];
      });
      row.push_back(cell ? (*cell)["endings"] : Value());
    });
    solvers.add_row(std::move(row));
  });
  std::vector<Value> all;
  each_row(runs, [&](const Row& row) { all.push_back(row["ending"]); });
  page.set("pathological-runs",
           all.empty() ? Value()
                       : value_of(fmt::format("Of {} runs on {} pathological problems, {}.",
                                              all.size(), problems.rows.size(),
                                              std::get<std::string>(endings_in_words(all)))));
  page.add(std::move(problems));
  page.add(std::move(solvers));
  return !all.empty();
}

}  // namespace ricochet::studies::comparison
