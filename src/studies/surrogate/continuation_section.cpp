#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "src/studies/surrogate/continuation_study.h"

namespace ricochet::studies::surrogate {
namespace {

/// Columns of the table: a solver with a budget.
std::vector<std::pair<std::string, long>> columns_of(const ContinuationStudy& study) {
  std::vector<std::pair<std::string, long>> columns;
  for (const Guidance& row : study.rows) {
    if (row.id == study.rows.front().id) columns.emplace_back(row.solver, row.budget);
  }
  return columns;
}

std::string distance(double regret) {
  return std::isfinite(regret) ? fmt::format("{:.3f}", regret) : "none found";
}

}  // namespace

report::Section continuation_section(const ContinuationStudy& study) {
  report::Section section{"guidance", "Does it help to come from wide to narrow?"};
  const auto columns = columns_of(study);
  std::map<std::pair<std::string, long>, int> solved;
  for (const Guidance& row : study.rows) solved[{row.solver, row.budget}] += row.solved;
  const int runs = static_cast<int>(study.rows.size() / columns.size()) * study.plan.instances;
  const auto share = [&](const std::pair<std::string, long>& column) {
    return fmt::format("{:.0f} %", 100.0 * solved[column] / runs);
  };
  std::string found;
  for (const auto& column : columns) {
    if (column.second != study.plan.budgets.back()) continue;
    found += fmt::format("{}{} {}", found.empty() ? "" : ", ", column.first, share(column));
  }
  section.paragraphs = {
      fmt::format("Found: so many of the runs find the fastest quiet speed of C1..C10, to {} rad/s "
                  "and judged by the true count, with {} evaluations: {}.",
                  speed_tolerance, study.plan.budgets.back(), found),
      fmt::format(
          "Each solver from {} starts, in boxes shifted and reflected. Alone, it sees the "
          "surrogate at width 0.25, whose constraint ends elsewhere than the count's. Led, it sees "
          "width 0.3 first, half of it next, down to 0.001, always from where it came to; at last "
          "it looks at the count itself, along a line, for where the constraint truly ends. A "
          "value costs one evaluation, with its derivative two.",
          study.plan.instances)};
  report::Table table{
      fmt::format("Runs of {} that found the fastest quiet speed; evaluations in brackets.",
                  study.plan.instances),
      {{"case", report::Alignment::left}},
      {}};
  for (const auto& [solver, budget] : columns) {
    table.columns.push_back({fmt::format("{} ({})", solver, budget)});
  }
  report::Table failures{
      "Where runs did not find it: how far the worst one stayed away, and what "
      "the solver said.",
      {{"case", report::Alignment::left},
       {"solver", report::Alignment::left},
       {"evaluations"},
       {"not found"},
       {"worst, short by [rad/s]"},
       {"it said", report::Alignment::left}},
      {}};
  for (std::size_t first = 0; first < study.rows.size(); first += columns.size()) {
    std::vector<report::Cell> cells = {{study.rows[first].id}};
    for (std::size_t k = first; k < first + columns.size(); ++k) {
      const Guidance& row = study.rows[k];
      const bool all = row.solved == study.plan.instances;
      cells.push_back(
          {fmt::format("{}", row.solved), all ? report::State::good : report::State::neutral});
      if (!all && row.solver.rfind("continuation-", 0) == 0) {
        failures.rows.push_back({{row.id},
                                 {row.solver},
                                 {fmt::format("{}", row.budget)},
                                 {fmt::format("{}", study.plan.instances - row.solved)},
                                 {distance(row.worst_regret)},
                                 {row.exit}});
      }
    }
    table.rows.push_back(std::move(cells));
  }
  std::vector<report::Cell> totals = {{"all"}};
  for (const auto& column : columns) totals.push_back({share(column)});
  table.rows.push_back(std::move(totals));
  section.tables = {std::move(table)};
  if (!failures.rows.empty()) section.tables.push_back(std::move(failures));
  return section;
}

}  // namespace ricochet::studies::surrogate
