#include "src/benchmark/export/summary_row.h"

#include <fmt/format.h>

#include <cmath>

#include "src/core/label.h"

namespace ricochet::exports {
namespace {

std::string count(double value) {
  if (std::isinf(value)) return "inf";
  return value < 1e7 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

std::string percent(double share) {
  return fmt::format("{:.0f}", 100 * share);
}

template <class Text>
std::string interval(const Interval& interval, Text text) {
  return fmt::format("{} to {}", text(interval.lower), text(interval.upper));
}

}  // namespace

std::vector<std::string> summary_names() {
  return {"problem", "solver", "formulation", "perturbation", "price", "budget"};
}

std::vector<std::string> summary_figures() {
  return {"runs", "solved %", "95 % interval", "ERT", "95 % interval", "failed"};
}

std::string summary_legend() {
  return "Budgets are evaluations per variable; price: evaluations charged for a gradient, n: the "
         "number of variables. Solved: share of runs that evaluated a feasible point within the "
         "problem's tolerance of its best known value; identical runs count once; Wilson's "
         "interval. ERT: expected running time, evaluations until solved; unsolved runs count with "
         "all their evaluations. Failed: runs that ended in an exception or were killed.";
}

SummaryRow summary_row(const comparison::JudgedCell& judged) {
  const comparison::Result result = comparison::result_of(judged.outcomes);
  const Cell& cell = judged.cell;
  const auto& time = result.running_time;
  return {{cell.problem, cell.solver, cell.formulation, label(cell.perturbation),
           cell.gradient_price, std::to_string(cell.budget)},
          {std::to_string(result.runs), percent(result.found.share),
           interval(result.found.interval, percent), time ? count(time->value) : "-",
           time ? interval(time->interval, count) : "-", std::to_string(result.failed)},
          result.failed};
}

}  // namespace ricochet::exports
