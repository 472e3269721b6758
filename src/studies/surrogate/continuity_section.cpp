#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/statistics/bootstrap.h"
#include "src/studies/surrogate/continuity.h"

namespace ricochet::studies::surrogate {
namespace {

using JumpsByWidth = std::vector<std::vector<double>>;

/// The jumps of all cases at each width, rising.
JumpsByWidth by_width(const ContinuityStudy& study, JumpsByWidth ContinuityRow::*kind) {
  JumpsByWidth all(study.plan.widths.size());
  for (const ContinuityRow& row : study.rows) {
    for (std::size_t w = 0; w < all.size(); ++w) {
      all[w].insert(all[w].end(), (row.*kind)[w].begin(), (row.*kind)[w].end());
    }
  }
  for (auto& jumps : all) std::sort(jumps.begin(), jumps.end());
  return all;
}

std::size_t larger_than(double limit, const std::vector<double>& rising) {
  return static_cast<std::size_t>(rising.end() -
                                  std::upper_bound(rising.begin(), rising.end(), limit));
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
      "All cases together: jumps of the surrogate between two neighbouring numbers, in impacts, "
      "where it changes most and where a strike is born; the shares of them that are smaller.",
      {{"width"},
       {"where", report::Alignment::left},
       {"segments"},
       {"0.5"},
       {"0.9"},
       {"0.99"},
       {"0.999"},
       {"all"}},
      {}};
  const auto add = [&](std::size_t w, const char* where, const std::vector<double>& jumps) {
    if (jumps.empty()) return;
    std::vector<report::Cell> cells = {
        {fmt::format("{:g}", study.plan.widths[w])}, {where}, {fmt::format("{}", jumps.size())}};
    for (const double share : {0.5, 0.9, 0.99, 0.999}) {
      cells.push_back({fmt::format("{:.1e}", quantile(jumps, share))});
    }
    cells.push_back(cell_of(jumps.back()));
    table.rows.push_back(std::move(cells));
  };
  const auto jumps = by_width(study, &ContinuityRow::jumps);
  const auto births = by_width(study, &ContinuityRow::births);
  for (std::size_t w = 0; w < jumps.size(); ++w) {
    add(w, "steepest", jumps[w]);
    add(w, "birth", births[w]);
  }
  return table;
}

/// The share of the segments whose largest jump is larger than so much.
report::Figure tails_of(const ContinuityStudy& study) {
  report::Chart chart;
  chart.name = "continuity";
  chart.title = "How many jumps are larger";
  chart.x = {"jump of the surrogate [impacts]", report::Scale::logarithmic,
             report::Range{1e-16, 1}};
  chart.y = {"share of the jumps", report::Scale::logarithmic};
  const auto draw = [&](std::string label, const std::vector<double>& jumps) {
    report::Series series{std::move(label), report::Mark::line, {}};
    for (int k = 0; k <= 60; ++k) {
      const double jump = 1e-16 * std::pow(10.0, 0.25 * k);
      const std::size_t larger = larger_than(jump, jumps);
      if (larger == 0) break;
      series.samples.push_back(
          {jump, static_cast<double>(larger) / static_cast<double>(jumps.size())});
    }
    if (!series.samples.empty()) chart.series.push_back(std::move(series));
  };
  const auto jumps = by_width(study, &ContinuityRow::jumps);
  const auto births = by_width(study, &ContinuityRow::births);
  for (std::size_t w = 0; w < jumps.size(); ++w) {
    draw(fmt::format("width {:g}, steepest", study.plan.widths[w]), jumps[w]);
    draw(fmt::format("width {:g}, birth", study.plan.widths[w]), births[w]);
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
  std::vector<double> exponents;
  for (const ContinuityRow& row : study.rows) {
    segments += row.segments;
    count_jumps += row.count_jumps;
    exponents.insert(exponents.end(), row.exponents.begin(), row.exponents.end());
  }
  std::size_t births = 0;
  std::size_t larger = 0;
  std::string worst_by_width;
  const auto steepest = by_width(study, &ContinuityRow::jumps);
  const auto born = by_width(study, &ContinuityRow::births);
  for (std::size_t w = 0; w < steepest.size(); ++w) {
    births += born[w].size();
    larger += larger_than(largest_allowed, steepest[w]) + larger_than(largest_allowed, born[w]);
    const double worst = std::max(steepest[w].back(), born[w].empty() ? 0.0 : born[w].back());
    worst_by_width += fmt::format("{}{:.1e} impacts at width {:g}", w > 0 ? ", " : "", worst,
                                  study.plan.widths[w]);
  }
  const double widest = *std::max_element(study.plan.widths.begin(), study.plan.widths.end());
  const double weight = carrier_track::step(
      std::log(carrier_track::resting_speed / carrier_track::default_reading().scene.slowest),
      widest);
  std::string finding = fmt::format(
      "Found: on {} random segments through the constants of C1..C12 the count jumps on {:.1f} %. "
      "The surrogate changes between two neighbouring numbers by no more than {}, where it changes "
      "most and at {} places where a strike is born or lost: {}.",
      segments, 100.0 * static_cast<double>(count_jumps) / static_cast<double>(segments),
      worst_by_width, births,
      larger == 0 ? fmt::format("all below {:.0e}", largest_allowed)
                  : fmt::format("{} of these changes are above {:.0e}", larger, largest_allowed));
  if (!exponents.empty()) {
    finding += fmt::format(
        " From 1e-10 to 1e-12 of the segment the change at a birth shrinks with a power of the "
        "distance of {:.2f} in the median; {} of {} have less than 0.4. A jump has 0, a root 1/2; "
        "less than 1/2 is also where a root and a slope of opposite signs cancel.",
        quantile(exponents, 0.5),
        std::count_if(exponents.begin(), exponents.end(), [](double p) { return p < 0.4; }),
        exponents.size());
  }
  section.paragraphs = {
      std::move(finding),
      fmt::format(
          "A segment starts at a random speed in 1..17 rad/s, with friction and clearance of a "
          "case changed by up to a quarter and restitution to between 0.75 and 1.05 of the case's; "
          "along it all four change evenly at once, by up to 0.5 rad/s, 0.02, 0.05 of restitution "
          "and 5 % of the clearance. Count and surrogate are computed at 17 points. Of the 16 "
          "pieces the one over which the surrogate changes most is halved, always into the half "
          "with the larger change, down to two neighbouring double-precision numbers: a jump, if "
          "there is one that is larger than what the surrogate changes beside it, is what is left. "
          "A small one could hide from this; so the number of strikes, impacts on another wall "
          "than the one before, is followed by bisection, too, to where it changes: a wall is "
          "touched there, or the window ends. Rounding alone leaves a little, too: an impact that "
          "is "
          "born strikes with the root of the distance from its birth, so that a distance of one "
          "rounding, 1e-16, is felt as 1e-8. At width 1 the surrogate counts "
          "it as its speed over the limit, some 1e-6; at narrower ones it does not show, but what "
          "follows does. And the last of ever smaller hops, "
          "slower "
          "than {:.0e} m/s, are left out: of an impact at that speed the surrogate would count "
          "{:.1e} at width {:g}. The cases that bounce best cost most, and get an eighth of "
          "the others' segments. Seed {}.",
          carrier_track::resting_speed, weight, widest, study.plan.seed)};
  section.tables = {width_table(study), case_table(study)};
  section.figures = {tails_of(study)};
  return section;
}

}  // namespace ricochet::studies::surrogate
