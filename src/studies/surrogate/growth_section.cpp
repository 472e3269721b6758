#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/report/text.h"
#include "src/studies/surrogate/growth.h"

namespace ricochet::studies::surrogate {
namespace {

using report::Mark;

/// What is told of the first window in which something holds.
template <class Holds>
std::optional<double> first_turns(const GrowthRow& row, const Holds& holds) {
  for (const GrowthCell& cell : row.cells) {
    if (holds(cell)) return cell.turns;
  }
  return std::nullopt;
}

std::optional<double> sensitive_from(const GrowthRow& row) {
  return first_turns(row,
                     [](const GrowthCell& c) { return c.trust.doubt == GradientDoubt::sensitive; });
}

std::optional<double> blind_wrong_from(const GrowthRow& row) {
  return first_turns(row, [](const GrowthCell& c) { return c.error_of(c.blind) > useless; });
}

std::optional<double> within_wrong_from(const GrowthRow& row) {
  return first_turns(row, [](const GrowthCell& c) { return c.error_of(c.within) > useless; });
}

bool forgets(const GrowthRow& row) {
  return !row.cells.back().sensitivity.exponent();
}

report::Figure scatter_of(const GrowthStudy& study) {
  report::Chart chart;
  chart.name = "growth-rates";
  chart.title = fmt::format("Growth of a derivative, {:g} turns", study.plan.turns.back());
  chart.x.label = "Lyapunov exponent, or growth between rests on a wall [1/s]";
  chart.y.label = "rate of the derivative [1/s]";
  report::Series moving{"never rests on a wall", Mark::points, {}};
  report::Series resting{"rests on a wall", Mark::points, {}};
  double lowest = 0;
  double highest = 0;
  for (const GrowthRow& row : study.rows) {
    const GrowthCell& cell = row.cells.back();
    if (!cell.rate) continue;
    (forgets(row) ? resting : moving).samples.push_back({cell.sensitivity.growth, *cell.rate});
    lowest = std::min(lowest, cell.sensitivity.growth);
    highest = std::max(highest, cell.sensitivity.growth);
  }
  for (report::Series* series : {&moving, &resting}) {
    if (!series->samples.empty()) chart.series.push_back(std::move(*series));
  }
  chart.series.push_back(
      {"theory: the exponent or zero", Mark::line, {{lowest, 0}, {0, 0}, {highest, highest}}});
  chart.width = 640;
  chart.height = 420;
  return {chart,
          "A point a motion. Where differences grow, at the right, derivatives with respect to the "
          "driving grow as fast; where they die out, at the left, derivatives become a constant. "
          "Between, in so many turns, they are still on their way there. A motion that rests on a "
          "wall forgets there what has grown since the last time: its derivatives do not grow."};
}

report::Figure courses_of(const GrowthStudy& study) {
  report::Chart chart;
  chart.name = "growth-courses";
  chart.title = "A derivative along the window";
  chart.x.label = "time, share of the window";
  chart.y = {"derivative of an impact [m s]", report::Scale::logarithmic};
  const auto draw = [&](const GrowthRow& row) {
    report::Series series{row.driven.name, Mark::line, {}};
    const double window = row.stretched.empty() ? 1 : row.stretched.back().time;
    const std::size_t stride = 1 + row.stretched.size() / 600;
    for (std::size_t k = 0; k < row.stretched.size(); k += stride) {
      series.samples.push_back({row.stretched[k].time / window, row.stretched[k].length});
    }
    if (!series.samples.empty()) chart.series.push_back(std::move(series));
  };
  const auto gaps = std::find_if(study.rows.begin(), study.rows.end(),
                                 [](const GrowthRow& row) { return row.driven.shaken; });
  for (auto row = gaps; row != study.rows.end() && row < gaps + 3; ++row) draw(*row);
  for (auto row = study.rows.begin(); row != gaps; ++row) {
    if (row->driven.name.starts_with("C2 ") || row->driven.name.starts_with("C10 ")) {
      draw(*row);
      if (chart.series.size() >= 5) break;
    }
  }
  chart.width = 640;
  chart.height = 420;
  return {chart,
          "How far impacts move when the driving changes by 1 rad/s: position at a given phase of "
          "the driving, and speed over its rate. Straight up: exponential growth, chaos. Level: "
          "every turn forgets the one before."};
}

std::string turns_or_never(const std::optional<double>& turns) {
  return turns ? fmt::format("{:g}", *turns) : "never";
}

/// To the hundredths, without the sign of a zero.
std::optional<double> rounded(const std::optional<double>& rate) {
  return rate ? std::optional(std::round(100 * *rate) / 100 + 0.0) : std::nullopt;
}

report::Table table_of(const GrowthStudy& study) {
  report::Table table{
      fmt::format(
          "Derivatives in windows of {:g} to {:g} turns of the driving. Exponent and rate are of "
          "the longest. A difference is wrong from where it is off by a tenth; \"within reach\": "
          "with steps of a quarter of the reach that the gradient tells, which differences by "
          "themselves do not know.",
          study.plan.turns.front(), study.plan.turns.back()),
      {{"motion", report::Alignment::left},
       {"Lyapunov exponent [1/s]"},
       {"growth between rests [1/s]"},
       {"rate of the derivative [1/s]"},
       {"slope of the surrogate, shortest window"},
       {"longest"},
       {"called sensitive from turns"},
       {"differences wrong from turns"},
       {"those within reach"}},
      {}};
  for (const GrowthRow& row : study.rows) {
    const GrowthCell& longest = row.cells.back();
    const auto exponent = longest.sensitivity.exponent();
    table.rows.push_back({{row.driven.name},
                          {exponent ? fmt::format("{:.2f}", *exponent) : "-infinity"},
                          {fmt::format("{:.2f}", longest.sensitivity.growth)},
                          {report::text_or_dash(rounded(longest.rate), "{:.2f}")},
                          {fmt::format("{:.1e}", row.cells.front().gradient)},
                          {fmt::format("{:.1e}", longest.gradient)},
                          {turns_or_never(sensitive_from(row))},
                          {turns_or_never(blind_wrong_from(row))},
                          {turns_or_never(within_wrong_from(row))}});
  }
  return table;
}

struct Totals {
  int cases = 0, forgetting = 0, doubted = 0;  // of the paper's cases
  double fastest = 0, worst = 0;               // rate [1/s], and error of a difference
  int chaotic = 0, warned = 0, blind = 0, within = 0;
  double apart = 0;  // of rate and exponent, relative
};

Totals totals_of(const GrowthStudy& study) {
  Totals totals;
  for (const GrowthRow& row : study.rows) {
    const GrowthCell& longest = row.cells.back();
    if (!row.driven.shaken) {
      ++totals.cases;
      totals.forgetting += forgets(row);
      totals.doubted += sensitive_from(row).has_value();
      totals.fastest = std::max(totals.fastest, std::abs(longest.rate.value_or(0)));
      for (const GrowthCell& cell : row.cells) {
        totals.worst = std::max(totals.worst, cell.error_of(cell.within));
      }
    } else if (longest.sensitivity.chaotic() && longest.rate) {
      ++totals.chaotic;
      totals.apart =
          std::max(totals.apart, std::abs(*longest.rate / longest.sensitivity.growth - 1));
      totals.warned += sensitive_from(row).has_value();
      totals.blind += blind_wrong_from(row).has_value();
      totals.within += within_wrong_from(row).has_value();
    }
  }
  return totals;
}

std::string finding(const GrowthStudy& study) {
  const Totals t = totals_of(study);
  return fmt::format(
      "Found: {} of the {} gradients of the paper's cases are called sensitive in windows of up to "
      "{:g} turns. {} of these motions rest on a wall, which forgets; their derivatives grow or "
      "shrink by {:.2f} per second at most, and differences with steps within the reach agree with "
      "them to {:.0e} or better. In {} chaotic motions beside them derivatives grow exponentially, "
      "at the rate of the Lyapunov exponent within {:.0f} %. There {} gradients come to be called "
      "sensitive; blind differences come to be wrong in {}, and those with steps within the reach "
      "in {}.",
      t.doubted == 0 ? "none" : std::to_string(t.doubted), t.cases, study.plan.turns.back(),
      t.forgetting == t.cases ? "All" : std::to_string(t.forgetting), t.fastest, t.worst, t.chaotic,
      100 * t.apart, t.warned, t.blind, t.within);
}

}  // namespace

report::Section growth_section(const GrowthStudy& study) {
  report::Section section{"growth", "How long are gradients good for?"};
  section.paragraphs = {
      finding(study),
      "Dual numbers carry the derivative with respect to the speed of the driver plate, or in a "
      "shaken gap the frequency of its shaking, through every impact. Of each impact that counts "
      "the derivative of its time and speed is noted, as the distance by which a change of 1 rad/s "
      "moves the body at a given phase of the driving; its rate of growth is the slope of the "
      "logarithm of that distance over time, from the first tenth of the window on. Beside it "
      "stands the Lyapunov exponent, from the growth of a difference in the start. Shaken gaps are "
      "the chaotic scene of the report on the dynamics and others like it, with its pull times a "
      "factor and another restitution. Differences are extrapolated from steps of a thousandth of "
      "the rate, halved twelve times."};
  section.tables = {table_of(study)};
  section.figures = {scatter_of(study), courses_of(study)};
  add_grazes(study.grazes, section);
  return section;
}

}  // namespace ricochet::studies::surrogate
