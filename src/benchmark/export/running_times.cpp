#include "src/benchmark/export/running_times.h"

#include "src/benchmark/analysis/result.h"
#include "src/benchmark/export/csv_row.h"
#include "src/core/one_line.h"

namespace ricochet::exports {

RunningTimes::RunningTimes(const std::filesystem::path& file) : file_(file) {
  file_.write(csv_row({"algorithm", "function_id", "problem", "variables", "solver", "formulation",
                       "perturbation", "gradient_price", "budget_per_variable", "runs",
                       "distinct_runs", "failed_runs", "solved_share", "solved_share_lower",
                       "solved_share_upper", "expected_running_time", "expected_running_time_lower",
                       "expected_running_time_upper"}));
}

void RunningTimes::add(const comparison::JudgedCell& judged, Numbering& numbering) {
  const Cell& cell = judged.cell;
  const comparison::Result result = comparison::result_of(judged.outcomes);
  const auto& time = result.running_time;
  file_.write(csv_row(
      {numbering.algorithm(cell), std::to_string(numbering.function_id(cell.problem)),
       one_line(cell.problem), std::to_string(judged.problem.variables), one_line(cell.solver),
       one_line(cell.formulation), one_line(cell.perturbation), one_line(cell.gradient_price),
       std::to_string(cell.budget), std::to_string(result.runs), std::to_string(result.distinct),
       std::to_string(result.failed), number(result.found.share),
       number(result.found.interval.lower), number(result.found.interval.upper),
       time ? number(time->value) : "", time ? number(time->interval.lower) : "",
       time ? number(time->interval.upper) : ""}));
}

}  // namespace ricochet::exports
