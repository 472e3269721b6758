#include "src/export/running_times.h"

#include "src/contest/result.h"
#include "src/core/one_line.h"
#include "src/export/csv_row.h"

namespace ricochet::exports {

RunningTimes::RunningTimes(const std::filesystem::path& file) : file_(file) {
  file_.write(
      csv_row({"algorithm", "function_id", "question", "variables", "solver", "form", "feature",
               "gradient_price", "budget_per_variable", "runs", "distinct_runs", "failed_runs",
               "solved_share", "solved_share_lower", "solved_share_upper", "expected_running_time",
               "expected_running_time_lower", "expected_running_time_upper"}));
}

void RunningTimes::add(const JudgedCell& judged, Numbering& numbering) {
  const Cell& cell = judged.cell;
  const contest::Result result = contest::result_of(judged.outcomes);
  const auto& time = result.running_time;
  file_.write(csv_row(
      {numbering.algorithm(cell), std::to_string(numbering.function_id(cell.question)),
       one_line(cell.question), std::to_string(judged.question.variables), one_line(cell.solver),
       one_line(cell.form), one_line(cell.feature), one_line(cell.gradient_price),
       std::to_string(cell.budget), std::to_string(result.runs), std::to_string(result.distinct),
       std::to_string(result.failed), number(result.found.share),
       number(result.found.interval.lower), number(result.found.interval.upper),
       time ? number(time->value) : "", time ? number(time->interval.lower) : "",
       time ? number(time->interval.upper) : ""}));
}

}  // namespace ricochet::exports
