#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/collisions.h"
#include "problems/carrier_track/fitted_reading.h"
#include "src/smoothing/continuity.h"
#include "src/statistics/bootstrap.h"

namespace ricochet::smoothing {
namespace {

/// The largest jumps of all cases at each width, rising.
std::vector<std::vector<double>> by_width(const ContinuityStudy& study) {
  std::vector<std::vector<double>> all(study.plan.widths.size());
  for (const ContinuityRow& row : study.rows) {
    for (std::size_t w = 0; w < all.size(); ++w) {
      all[w].insert(all[w].end(), row.jumps[w].begin(), row.jumps[w].end());
    }
  }
  for (auto& jumps : all) std::sort(jumps.begin(), jumps.end());
  return all;
}

report::Cell cell_of(double jump) {
  return {fmt::format("{:.1e}", jump),
          jump <= largest_allowed ? report::State::good : report::State::bad};
}

report::Table case_table(const ContinuityStudy& study) {
  report::Table table{
      "The largest jump of the surrogate between two neighbouring numbers, by case and smoothing "
      "width, in impacts; and how often the count itself jumps on the same segments.",
      {{"case", report::Alignment::left}, {"segments"}, {"the count jumps on [%]"}},
      {}};
  for (const double width : study.plan.widths) {
    table.columns.push_back({fmt::format("width {:g}: 0.99 of them below", width)});
    table.columns.push_back({"all below"});
  }
  for (const ContinuityRow& row : study.rows) {
    const double share =
        100.0 * static_cast<double>(row.count_jumps) / static_cast<double>(row.segments);
    std::vector<report::Cell> cells = {
        {row.id}, {fmt::format("{}", row.segments)}, {fmt::format("{:.1f}", share)}};
    for (const auto& jumps : row.jumps) {
      cells.push_back({fmt::format("{:.1e}", quantile(jumps, 0.99))});
      cells.push_back(cell_of(jumps.back()));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

report::Table width_table(const ContinuityStudy& study) {
  report::Table table{
      "All cases together: shares of the segments whose largest jump is below, in impacts.",
      {{"width"}, {"segments"}, {"0.5"}, {"0.9"}, {"0.99"}, {"0.999"}, {"all"}},
      {}};
  const auto all = by_width(study);
  for (std::size_t w = 0; w < all.size(); ++w) {
    std::vector<report::Cell> cells = {{fmt::format("{:g}", study.plan.widths[w])},
                                       {fmt::format("{}", all[w].size())}};
    for (const double share : {0.5, 0.9, 0.99, 0.999}) {
      cells.push_back({fmt::format("{:.1e}", quantile(all[w], share))});
    }
    cells.push_back(cell_of(all[w].back()));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// The share of the segments whose largest jump is larger than so much.
report::Figure tails_of(const ContinuityStudy& study) {
  report::Chart chart;
  chart.name = "continuity";
  chart.title = "How many segments have a larger jump";
  chart.x = {"largest jump of the surrogate [impacts]", report::Scale::logarithmic,
             report::Range{1e-16, 1}};
  chart.y = {"share of the segments", report::Scale::logarithmic};
  const auto all = by_width(study);
  for (std::size_t w = 0; w < all.size(); ++w) {
    report::Series series{fmt::format("width {:g}", study.plan.widths[w]), report::Mark::line, {}};
    const auto size = static_cast<double>(all[w].size());
    for (int k = 0; k <= 60; ++k) {
      const double jump = 1e-16 * std::pow(10.0, 0.25 * k);
      const auto larger = all[w].end() - std::upper_bound(all[w].begin(), all[w].end(), jump);
      if (larger == 0) break;
      series.samples.push_back({jump, static_cast<double>(larger) / size});
    }
    if (!series.samples.empty()) chart.series.push_back(std::move(series));
  }
  chart.lines = {{report::Direction::vertical, largest_allowed, "allowed"},
                 {report::Direction::vertical, 1.0, "the count's jump"}};
  chart.width = 640;
  return {chart,
          "Where the count jumps by one, the surrogate changes between neighbouring numbers by "
          "what rounding makes of it. The narrower the surrogate, the steeper it is, and the more "
          "rounding shows; the tail are impacts just born, which are as fast as the root of what "
          "their birth is rounded to."};
}

}  // namespace

report::Section continuity_section(const ContinuityStudy& study) {
  report::Section section{"continuity", "Is the surrogate continuous?"};
  std::size_t segments = 0;
  std::size_t count_jumps = 0;
  std::size_t larger = 0;
  double worst = 0;
  std::string worst_by_width;
  for (const ContinuityRow& row : study.rows) {
    segments += row.segments;
    count_jumps += row.count_jumps;
  }
  const auto all = by_width(study);
  for (std::size_t w = 0; w < all.size(); ++w) {
    worst = std::max(worst, all[w].back());
    larger += static_cast<std::size_t>(
        all[w].end() - std::upper_bound(all[w].begin(), all[w].end(), largest_allowed));
    worst_by_width += fmt::format("{}{:.1e} at width {:g}", w > 0 ? ", " : "", all[w].back(),
                                  study.plan.widths[w]);
  }
  const double widest = *std::max_element(study.plan.widths.begin(), study.plan.widths.end());
  const double weight = carrier_track::step(
      std::log(carrier_track::resting_speed / carrier_track::default_reading().scene.slowest),
      widest);
  section.paragraphs = {
      fmt::format(
          "Found: {}. On {} random segments through the constants of C1..C12 the count jumps on "
          "{:.1f} %; the largest jump of the surrogate between two neighbouring numbers is {:.1e} "
          "impacts ({}). {} of the segments pass the bound of {:.0e}.",
          larger == 0 ? "yes, up to rounding" : "no", segments,
          100.0 * static_cast<double>(count_jumps) / static_cast<double>(segments), worst,
          worst_by_width, larger == 0 ? "None" : std::to_string(larger), largest_allowed),
      fmt::format(
          "A segment starts at a random speed in 1..17 rad/s, with friction and clearance of a "
          "case changed by up to a quarter and restitution to between 0.75 and 1.05 of the case's; "
          "along it all four change evenly at once, by up to 0.5 rad/s, 0.02, 0.05 of restitution "
          "and 5 % of the clearance. Count and surrogate are computed at 17 points. Of the 16 "
          "pieces the one over which the surrogate changes most is halved, always into the half "
          "with the larger change, down to two neighbouring double-precision numbers: a jump, if "
          "there is one, is what is left. Rounding alone leaves a little, too: an impact that is "
          "born strikes with the root of the distance from its birth, so that a distance of one "
          "rounding, 1e-16, is felt as 1e-8. Hence the bound. And the last of ever smaller hops, "
          "slower "
          "than {:.0e} m/s, are left out: of an impact at that speed the surrogate would count "
          "{:.1e} at width {:g}. The cases that bounce best cost most, and get a quarter of the "
          "others' segments. Seed {}.",
          carrier_track::resting_speed, weight, widest, study.plan.seed)};
  section.tables = {width_table(study), case_table(study)};
  section.figures = {tails_of(study)};
  return section;
}

}  // namespace ricochet::smoothing
