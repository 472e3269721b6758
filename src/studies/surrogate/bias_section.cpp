#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "src/statistics/bootstrap.h"
#include "src/studies/surrogate/bias.h"

namespace ricochet::studies::surrogate {
namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

report::Table table_of(const CaseBias& row) {
  report::Table table{
      fmt::format("{}: the lowest count is {}, the fastest quiet speed {:.2f} rad/s. What the "
                  "surrogate makes of them.",
                  row.id, row.lowest, row.fastest),
      {{"width"},
       {"mean distance from the count"},
       {"rank correlation"},
       {"count at its minimum, above the lowest"},
       {"fastest speed it calls quiet [rad/s]"},
       {"short of the true one by [rad/s]"},
       {"truly quiet there", report::Alignment::left}},
      {}};
  for (const Bias& gap : row.gaps) {
    std::vector<report::Cell> cells = {
        {fmt::format("{}", gap.width)},
        {fmt::format("{:.3f}", gap.error)},
        {gap.rank_correlation ? fmt::format("{:.4f}", *gap.rank_correlation) : "-"},
        {fmt::format("{:.0f}", gap.count_regret),
         gap.count_regret > 0 ? report::State::bad : report::State::good}};
    if (gap.speed) {
      cells.push_back({fmt::format("{:.2f}", *gap.speed)});
      cells.push_back({fmt::format("{:+.2f}", *gap.speed_regret)});
      cells.push_back(
          {gap.loud ? "no" : "yes", gap.loud ? report::State::bad : report::State::good});
    } else {
      for (int i = 0; i < 3; ++i) cells.push_back({"-"});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// Distance in collisions and in speed, over the width.
report::Figure chart_of(const CaseBias& row) {
  report::Chart chart;
  chart.name = fmt::format("gap-{}", lower_case(row.id));
  chart.title = fmt::format("{}: the surrogate's gap", row.id);
  chart.x = {"smoothing width", report::Scale::logarithmic};
  chart.y = {"gap [collisions, rad/s]"};
  report::Series error{"distance from the count [collisions]", report::Mark::line, {}};
  report::Series regret{"count at its minimum, too high by [collisions]", report::Mark::line, {}};
  report::Series speed{"fastest quiet speed wrong by [rad/s]", report::Mark::line, {}};
  for (auto gap = row.gaps.rbegin(); gap != row.gaps.rend(); ++gap) {
    error.samples.push_back({gap->width, gap->error});
    regret.samples.push_back({gap->width, gap->count_regret});
    const auto wrong =
        gap->speed_regret ? std::optional(std::abs(*gap->speed_regret)) : std::nullopt;
    speed.samples.push_back({gap->width, wrong});
  }
  chart.series = {error, regret, speed};
  return {chart, fmt::format("What {} loses by smoothing.", row.id)};
}

/// Median and largest over the cases of something at one width.
template <class Of>
std::pair<double, double> over_cases(const BiasStudy& study, std::size_t width, Of of) {
  std::vector<double> values;
  for (const CaseBias& row : study.cases) values.push_back(of(row.gaps[width]));
  return {quantile(values, 0.5), *std::max_element(values.begin(), values.end())};
}

}  // namespace

report::Section bias_section(const BiasStudy& study) {
  report::Section section{"gap", "What does smoothing cost?"};
  const auto wrong = [](const Bias& gap) {
    return gap.speed_regret ? std::abs(*gap.speed_regret) : 18.0;
  };
  const std::size_t last = study.plan.widths.size() - 1;
  std::size_t usual = 0;
  while (usual < last && study.plan.widths[usual] > 0.25) ++usual;
  const auto [usual_median, usual_worst] = over_cases(study, usual, wrong);
  const auto [last_median, last_worst] = over_cases(study, last, wrong);
  int loud = 0;
  for (const CaseBias& row : study.cases) loud += row.gaps[usual].loud ? 1 : 0;
  section.paragraphs = {
      fmt::format(
          "Found: at width {} the fastest speed that the surrogate calls quiet is wrong by {:.2f} "
          "rad/s in the median of the cases, by {:.2f} at worst, and truly loud in {} of {}; at "
          "width {} by {:.2f} and {:.2f}. So one width is not enough: a solver has to come from a "
          "wide one to a narrow one.",
          study.plan.widths[usual], usual_median, usual_worst, loud, study.cases.size(),
          study.plan.widths[last], last_median, last_worst),
      fmt::format(
          "Every case at {} speeds up to 18 rad/s. An impact of margin z = ln(speed / slowest that "
          "counts) weighs 1 / (1 + exp(-z / width)), and less at the end of the window; the "
          "surrogate is the sum. Width 0 would be the count itself. The surrogate is called quiet "
          "up to half a collision above the highest quiet count.",
          std::lround(18 / study.plan.step))};
  for (const CaseBias& row : study.cases) {
    section.tables.push_back(table_of(row));
    section.figures.push_back(chart_of(row));
  }
  return section;
}

}  // namespace ricochet::studies::surrogate
