#include <fmt/format.h>

#include "src/core/problem.h"
#include "src/studies/surrogate/gradient_doubt.h"

namespace ricochet::studies::surrogate {
namespace {

double percent(int part, int whole) {
  return whole > 0 ? 100.0 * part / whole : 0.0;
}

int doubts_of(const Validity& v, GradientDoubt doubt) {
  return v.doubts[static_cast<std::size_t>(doubt)];
}

/// A map over cases and speeds.
template <class Of>
report::Figure map_of(const GradientDoubtStudy& study, std::string name, std::string title,
                      std::string label, std::optional<report::Range> range, std::string caption,
                      Of of) {
  report::Chart chart;
  chart.name = std::move(name);
  chart.title = std::move(title);
  chart.x.label = "speed [rad/s]";
  chart.y.label = "case";
  report::HeatMap map{std::move(label), {}, range};
  const double width = 18.0 / study.plan.cells;
  for (int k = 0; k < study.plan.cells; ++k) {
    chart.x.categories.push_back(fmt::format("{:.3g}", (k + 0.5) * width));
  }
  for (const ValidityRow& row : study.rows) {
    chart.y.categories.push_back(row.id);
    auto& cells = map.rows.emplace_back();
    for (const Validity& v : row.cells) cells.push_back(of(v));
  }
  chart.heat_map = std::move(map);
  chart.height = 360;
  return {chart, std::move(caption)};
}

report::Figure step_chart(const GradientDoubtStudy& study) {
  report::Chart chart;
  chart.name = "validity-steps";
  chart.title = "Differences against the exact gradient";
  chart.x = {"step, part of the range of speeds", report::Scale::logarithmic};
  chart.y = {"relative difference", report::Scale::logarithmic};
  report::Series median{"median", report::Mark::line, {}};
  report::Series upper{"0.9 quantile", report::Mark::line, {}};
  for (auto e = study.step_errors.rbegin(); e != study.step_errors.rend(); ++e) {
    median.samples.push_back({e->step, std::max(e->median, 1e-16)});
    upper.samples.push_back({e->step, std::max(e->upper, 1e-16)});
  }
  chart.series = {median, upper};
  return {chart,
          "Central differences over all points but the flat ones. On the left rounding, on the "
          "right the function's own bends; where both lines are low, both are right."};
}

report::Table width_table(const GradientDoubtStudy& study) {
  report::Table table{
      "What the gradient is worth at each smoothing width, over all cases and "
      "speeds.",
      {{"width"},
       {"points"},
       {"agrees with differences [%]"},
       {"flat [%]"},
       {"next to a kink [%]"},
       {"sensitive [%]"},
       {"sign of the count's trend [%]"},
       {"median reach, part of the range"}},
      {}};
  for (std::size_t w = 0; w < study.plan.widths.size(); ++w) {
    const Validity& v = study.by_width[w];
    const auto share = [&](GradientDoubt doubt) {
      return fmt::format("{:.1f}", percent(doubts_of(v, doubt), v.points));
    };
    table.rows.push_back({{fmt::format("{}", study.plan.widths[w])},
                          {fmt::format("{}", v.points)},
                          {fmt::format("{:.1f}", percent(v.agreeing, v.points))},
                          {share(GradientDoubt::flat)},
                          {share(GradientDoubt::kink)},
                          {share(GradientDoubt::sensitive)},
                          {fmt::format("{:.1f}", percent(v.right, v.trending))},
                          {fmt::format("{:.1e}", std::pow(10.0, v.log_reach))}});
  }
  return table;
}

}  // namespace

report::Section gradient_doubt_section(const GradientDoubtStudy& study) {
  report::Section section{"validity", "Where does the gradient mean something?"};
  Validity all;
  for (const ValidityRow& row : study.rows) {
    for (const Validity& v : row.cells) {
      all.points += v.points;
      all.agreeing += v.agreeing;
      all.trending += v.trending;
      all.right += v.right;
      for (std::size_t d = 0; d < all.doubts.size(); ++d) all.doubts[d] += v.doubts[d];
    }
  }
  section.paragraphs = {
      fmt::format(
          "Found: the exact gradient agrees with differences to six digits at {:.1f} % of {} "
          "points; {:.1f} % are flat, {:.2f} % next to a kink and {:.2f} % sensitive, and say so. "
          "Being exact is not enough: it points where the count goes, over half a rad/s to either "
          "side, at {:.0f} % of the points where either has a direction.",
          percent(all.agreeing, all.points), all.points,
          percent(doubts_of(all, GradientDoubt::flat), all.points),
          percent(doubts_of(all, GradientDoubt::kink), all.points),
          percent(doubts_of(all, GradientDoubt::sensitive), all.points),
          percent(all.right, all.trending)),
      "A gradient tells of the motion as it is. To first order it also tells how far that goes: an "
      "impact ends to be where its speed comes to 0, a wall that is missed is met where its "
      "distance does. The nearest of these is the gradient's reach, as a part of the range of "
      "speeds. A gradient is flat if it would change the surrogate by less than 0.001 across the "
      "whole range, next to a kink if its reach is below 0.0001, sensitive if so and an impact's "
      "time moves by more than 1000 windows across the range. Solvers are told with every "
      "gradient."};
  section.tables = {width_table(study)};
  section.figures = {
      map_of(study, "validity-agreement", "Points where differences agree [%]", "agree [%]",
             report::Range{0, 100}, "Agreement to six digits with differences of some step.",
             [](const Validity& v) { return std::optional(percent(v.agreeing, v.points)); }),
      map_of(study, "validity-trend", "Points where the gradient points as the count [%]",
             "same sign [%]", report::Range{0, 100},
             "Sign of the gradient against that of the count's slope over half a rad/s to either "
             "side. Hatched: the count does not move, or the gradient is flat.",
             [](const Validity& v) {
               return v.trending > 0 ? std::optional(percent(v.right, v.trending)) : std::nullopt;
             }),
      map_of(study, "validity-flat", "Points where the gradient is flat [%]", "flat [%]",
             report::Range{0, 100}, "Where the surrogate's gradient is zero, or next to it.",
             [](const Validity& v) {
               return std::optional(percent(doubts_of(v, GradientDoubt::flat), v.points));
             }),
      map_of(study, "validity-reach", "How far the gradient reaches", "log10 of the reach", {},
             "Median of the logarithm of the reach: -2 is a hundredth of the range of speeds.",
             [](const Validity& v) { return std::optional(v.log_reach); }),
      step_chart(study)};
  return section;
}

}  // namespace ricochet::studies::surrogate
