#include <fmt/format.h>

#include <algorithm>

#include "src/report/text.h"
#include "src/studies/dynamics/sections.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Alignment;

bool fixed_steps(const StabilityMap& map) {
  return spring_bound(map.method).has_value();
}

int count(const StabilityMap& map, Behaviour behaviour) {
  int sum = 0;
  for (const auto& row : map.cells) {
    sum += static_cast<int>(std::ranges::count(row, behaviour, &StabilityCell::behaviour));
  }
  return sum;
}

int cells_of(const StabilityMap& map) {
  return static_cast<int>(map.cells.size() * map.controls.size());
}

report::Table border_table(const StabilityStudy& study) {
  report::Table table{
      "Fixed steps: where walls begin to give energy, as the step h times the frequency w = "
      "sqrt(n K d^(n-1) / m) of the wall at the deepest point d of the fastest impact.",
      {{"method", Alignment::left},
       {"largest h w of a run that keeps its energy"},
       {"smallest of one that does not"},
       {"bound of theory on a spring"}},
      {}};
  for (const StabilityMap& map : study.maps) {
    if (!fixed_steps(map)) continue;
    const Border border = border_of(map, study.frequencies);
    table.rows.push_back({{map.method},
                          {fmt::format("{:.2f}", border.highest_good)},
                          {fmt::format("{:.2f}", border.lowest_bad)},
                          {fmt::format("{:.2f}", *spring_bound(map.method))}});
  }
  return table;
}

report::Table rest_table(const StabilityStudy& study) {
  report::Table table{
      fmt::format(
          "At rest on a wall of {:.0e} and of {:.0e} N/m^1.5: evaluations of the force, and "
          "the relative error of the depth at the end; – where the method gave up.",
          study.plan.stiffnesses.front(), study.plan.stiffnesses.back()),
      {{"method", Alignment::left},
       {"evaluations, soft"},
       {"error, soft"},
       {"evaluations, stiff"},
       {"error, stiff"}},
      {}};
  for (const RestCost& cost : study.rests) {
    const Rest &soft = cost.rests.front(), &stiff = cost.rests.back();
    table.rows.push_back({{cost.method},
                          {fmt::format("{:.0f}", soft.evaluations)},
                          {report::text_or_dash(soft.depth_error, "{:.0e}")},
                          {fmt::format("{:.0f}", stiff.evaluations)},
                          {report::text_or_dash(stiff.depth_error, "{:.0e}")}});
  }
  return table;
}

report::Table order_table(const StabilityStudy& study) {
  report::Table table{
      "Order of the speed after one impact by Runge-Kutta 4, whose own order is 4, where the edge "
      "of the contact is not located. Expected: one more than the power of the depth with which "
      "the force begins. Error: relative, on average over phases, at a step of a tenth of "
      "sqrt(m/K).",
      {{"wall", Alignment::left}, {"expected"}, {"measured"}, {"error"}},
      {}};
  for (const EdgeOrder& order : study.orders) {
    table.rows.push_back({{order.wall},
                          {fmt::format("{:.1f}", order.expected)},
                          {fmt::format("{:.2f}", order.measured)},
                          {fmt::format("{:.1e}", order.error)}});
  }
  return table;
}

std::string finding(const StabilityStudy& study) {
  std::string fixed, adaptive;
  int wrong = 0, all = 0;
  for (const StabilityMap& map : study.maps) {
    if (fixed_steps(map)) {
      fixed += fmt::format("{}{:.2f}/w by {}", fixed.empty() ? "" : " and ",
                           border_of(map, study.frequencies).lowest_bad, map.method);
      continue;
    }
    const int failed = cells_of(map) - count(map, Behaviour::right_count);
    wrong += failed;
    all += cells_of(map);
    if (failed > 0) {
      adaptive += fmt::format("{}{} {}", adaptive.empty() ? "" : ", ", map.method, failed);
    }
  }
  return fmt::format(
      "Found: with fixed steps a stiff wall throws a body back faster than it came, or lets it "
      "through, from a step of {} on, where w is the frequency of the body on the wall; methods "
      "that control their error count wrong in {} of {} runs{}.",
      fixed, wrong, all, wrong > 0 ? " (" + adaptive + ")" : "");
}

/// By how much the cheapest right count of a method is dearer on the stiffest walls than on the
/// softest; nothing if there is none.
std::optional<double> growth(const StabilityMap& map) {
  const auto soft = cheapest_right(map.cells.front());
  const auto stiff = cheapest_right(map.cells.back());
  if (!soft || !stiff) return std::nullopt;
  return stiff->evaluations / soft->evaluations;
}

std::string growths(const StabilityStudy& study) {
  std::string text;
  for (const StabilityMap& map : study.maps) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", map.method,
                        report::text_or_dash(growth(map), "{:.0f}"));
  }
  return fmt::format(
      "A tolerance keeps the steps small where a wall is met, and there alone. From the softest "
      "walls to the stiffest the force evaluations for a right count grow by these factors: {}.",
      text);
}

std::string hard_wall(const StabilityStudy& study) {
  const auto& row = study.hard.cells.front();
  int right = 0;
  for (const StabilityCell& cell : row) right += cell.behaviour == Behaviour::right_count ? 1 : 0;
  return fmt::format(
      "For comparison, {} on hard walls, which have no stiffness, counts right with {} of the {} "
      "steps.",
      study.hard.method, right, row.size());
}

std::string impacts_against_springs(const StabilityStudy& study) {
  std::string text;
  for (const ReturnCurve& curve : study.returns) {
    text += fmt::format("{}{} with a force ~ depth^{} from h w = {} on", text.empty() ? "" : ", ",
                        curve.method, curve.exponent,
                        report::text_or_dash(onset(curve, 1 / 0.9), "{:.2f}"));
  }
  return fmt::format(
      "Theory, made for a body that stays on a spring, bounds h w by 2 for semi-implicit Euler and "
      "by 2.83 for Runge-Kutta 4. An impact asks more: a step may end deep in the wall, and the "
      "next one throws the body out. An elastic wall returns a ninth too much, as much as a wall "
      "with restitution 0.9 takes, by {}. {}",
      text, hard_wall(study));
}

std::string rest(const StabilityStudy& study) {
  std::string settled, restless;
  for (const RestCost& cost : study.rests) {
    const auto& error = cost.rests.back().depth_error;
    std::string& names = error && *error < 1e-9 ? settled : restless;
    names += (names.empty() ? "" : ", ") + cost.method;
  }
  return fmt::format(
      "Rest is another matter: the stiffness stays, though nothing moves. A body of 1 kg is "
      "pressed with 10 N onto a damped wall, and has {} s to come to rest. On the stiffest wall "
      "the depth is right to 1e-9 by {}; by {} it is not: they go on trembling within their "
      "tolerance, and pay for every swing.",
      rest_seconds, settled.empty() ? "none" : settled, restless.empty() ? "none" : restless);
}

}  // namespace

report::Section stability_section(const StabilityStudy& study) {
  report::Section section{"stability", "Where methods fail: stiff walls"};
  section.paragraphs = {
      finding(study),
      "Simulators of contact often do not look for impacts at all: a wall is a spring with a "
      "damper, and the integrator goes straight through. Here a body of 1 kg flies through a "
      "shaken gap of 1 mm for 0.1 s, at 0.1 m/s at first, and each wall returns 0.9 of its speed. "
      "The number of impacts is compared with that of the event-driven simulator on the same "
      "walls. A wall gives energy where the body leaves faster than it came.",
      impacts_against_springs(study), growths(study), rest(study)};
  section.tables = {border_table(study), order_table(study), rest_table(study)};
  section.figures = stability_charts(study);
  return section;
}

}  // namespace ricochet::studies::dynamics
