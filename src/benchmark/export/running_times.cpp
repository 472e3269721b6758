#include "src/benchmark/export/running_times.h"

#include "src/benchmark/analysis/result.h"
#include "src/benchmark/export/csv_row.h"
#include "src/benchmark/export/label_of.h"

namespace ricochet::exports {
namespace {

/// Adds success rate and expected running time, each with its interval.
void add_to(std::vector<std::string>& row, const comparison::SolvedShare& solved,
            const std::optional<comparison::Estimate>& time) {
  for (const double share : {solved.share, solved.interval.lower, solved.interval.upper}) {
    row.push_back(number(share));
  }
  row.push_back(time ? number(time->value) : "");
  row.push_back(time ? number(time->interval.lower) : "");
  row.push_back(time ? number(time->interval.upper) : "");
}

}  // namespace

RunningTimes::RunningTimes(const std::filesystem::path& file) : file_(file) {
  file_.write(csv_row({"algorithm",
                       "function_id",
                       "problem",
                       "variables",
                       "solver",
                       "formulation",
                       "perturbation",
                       "gradient_price",
                       "budget_per_variable",
                       "runs",
                       "distinct_runs",
                       "failed_runs",
                       "solved_share",
                       "solved_share_lower",
                       "solved_share_upper",
                       "expected_running_time",
                       "expected_running_time_lower",
                       "expected_running_time_upper",
                       "returned_solved_share",
                       "returned_solved_share_lower",
                       "returned_solved_share_upper",
                       "returned_expected_running_time",
                       "returned_expected_running_time_lower",
                       "returned_expected_running_time_upper"}));
}

void RunningTimes::add(const comparison::JudgedCell& judged, Numbering& numbering) {
  const Cell& cell = judged.cell;
  const comparison::Result result = comparison::result_of(judged.outcomes);
  std::vector<std::string> row = {
      numbering.algorithm(cell),       std::to_string(numbering.function_id(cell.problem)),
      label_of(cell.problem),          std::to_string(judged.problem.variables),
      label_of(cell.solver),           label_of(cell.formulation),
      label_of(cell.perturbation),     label_of(cell.gradient_price),
      std::to_string(cell.budget),     std::to_string(result.runs),
      std::to_string(result.distinct), std::to_string(result.failed)};
  add_to(row, result.found, result.running_time);
  add_to(row, result.returned, result.returned_running_time);
  file_.write(csv_row(row));
}

}  // namespace ricochet::exports
