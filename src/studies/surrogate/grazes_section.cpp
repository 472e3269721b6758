#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/gradients/trust.h"
#include "src/report/text.h"
#include "src/studies/surrogate/grazes.h"

namespace ricochet::studies::surrogate {
namespace {

using carrier_track::short_reach;

/// The first of each case that has one that something follows.
std::vector<const GrazeRow*> shown_of(const GrazeStudy& study) {
  std::vector<const GrazeRow*> shown;
  for (const GrazeRow& row : study.rows) {
    if (!row.followed()) continue;
    if (shown.empty() || shown.back()->id != row.id) shown.push_back(&row);
  }
  return shown;
}

std::string name_of(const GrazeRow& row) {
  return fmt::format("{} at {:.3f} rad/s", row.id, row.graze.omega);
}

report::Axis distances() {
  return {"distance from the graze, share of 18 rad/s", report::Scale::logarithmic};
}

report::Figure slopes_of(const GrazeStudy& study, std::size_t width) {
  report::Chart chart;
  chart.name = fmt::format("graze-slopes-{}", width + 1);
  chart.title = fmt::format("Slope next to a graze, width {:g}", study.plan.widths[width]);
  chart.x = distances();
  chart.y = {"|slope of the surrogate| [impacts per rad/s]", report::Scale::logarithmic};
  report::Series missed{"the wall is missed, all", report::Mark::points, {}};
  for (const GrazeRow* row : shown_of(study)) {
    report::Series hit{name_of(*row) + ", hit", report::Mark::line, {}};
    for (const Approach& a : row->approaches[width]) {
      if (a.hit_slope != 0) hit.samples.push_back({a.distance, std::abs(a.hit_slope)});
      if (a.missed_slope != 0) missed.samples.push_back({a.distance, std::abs(a.missed_slope)});
    }
    std::reverse(hit.samples.begin(), hit.samples.end());
    if (!hit.samples.empty()) chart.series.push_back(std::move(hit));
  }
  if (!missed.samples.empty()) chart.series.push_back(std::move(missed));
  chart.width = 640;
  chart.height = 420;
  return {chart,
          "From right to left the graze comes nearer. Where the wall is hit (lines) the slope "
          "grows like the distance to the power of -1/2, a straight line here; where it is missed "
          "(points) the slope stays what it is. A dip is a change of sign; a hump, the born "
          "impact itself, where it passes the limit from which it counts."};
}

report::Figure reaches_of(const GrazeStudy& study) {
  report::Chart chart;
  chart.name = "graze-reach";
  chart.title = "What a gradient knows of the graze ahead";
  chart.x = distances();
  chart.y = {"reach told, share of 18 rad/s", report::Scale::logarithmic};
  report::Series hit{"the wall is hit", report::Mark::points, {}};
  report::Series missed{"the wall is missed", report::Mark::points, {}};
  report::Series equal{"reach = distance", report::Mark::line, {}};
  for (const GrazeRow& row : study.rows) {
    for (const Approach& a : row.approaches.front()) {
      if (std::isfinite(a.hit_reach)) hit.samples.push_back({a.distance, a.hit_reach});
      if (std::isfinite(a.missed_reach)) missed.samples.push_back({a.distance, a.missed_reach});
    }
  }
  const auto& d = study.plan.distances;
  equal.samples = {{d.back(), d.back()}, {d.front(), d.front()}};
  chart.series = {std::move(equal), std::move(hit), std::move(missed)};
  chart.lines = {{report::Direction::horizontal, short_reach, "in doubt below"}};
  chart.width = 640;
  chart.height = 420;
  return {chart,
          "Every exact gradient comes with its reach: how far away, to first order, the motion "
          "changes its structure. On the line it tells the distance of the graze right. Far away, "
          "on the right, another event is nearer."};
}

/// Farthest ratio of reach and distance from 1, over the grazes at distances up to `most`.
double worst_reach(const GrazeStudy& study, double most) {
  double worst = 0;
  for (const GrazeRow& row : study.rows) {
    for (const Approach& a : row.approaches.front()) {
      if (a.distance > 1.01 * most) continue;
      worst = std::max({worst, std::abs(a.hit_reach / a.distance - 1),
                        std::abs(a.missed_reach / a.distance - 1)});
    }
  }
  return worst;
}

report::Table table_of(const GrazeStudy& study) {
  report::Table table{
      "Grazes of the cases. Exponent: p of |slope where the wall is hit - slope where it is "
      "missed| ~ distance^p, fitted between 1e-11 and 1e-7 of the range; -1/2 in theory. Reach: "
      "what the gradient nearest to the graze says of it, over the distance.",
      {{"case", report::Alignment::left},
       {"at [rad/s]"},
       {"wall", report::Alignment::left},
       {"hit", report::Alignment::left}},
      {}};
  for (const double width : study.plan.widths) {
    table.columns.push_back({fmt::format("exponent, width {:g}", width)});
  }
  table.columns.push_back({"reach / distance, hit"});
  table.columns.push_back({"missed"});
  for (const GrazeRow& row : study.rows) {
    std::vector<report::Cell> cells = {
        {row.id},
        {fmt::format("{:.9f}", row.graze.omega)},
        {row.graze.wall == carrier_track::Wall::upper ? "upper" : "lower"},
        {row.graze.side > 0 ? "above" : "below"}};
    for (const auto& exponent : row.exponents) {
      cells.push_back({report::text_or_dash(exponent, "{:.4f}")});
    }
    const Approach& nearest = row.approaches.front().back();
    cells.push_back({fmt::format("{:.4f}", nearest.hit_reach / nearest.distance)});
    cells.push_back({fmt::format("{:.4f}", nearest.missed_reach / nearest.distance)});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace

void add_grazes(const GrazeStudy& study, report::Section& section) {
  if (shown_of(study).empty()) {
    section.paragraphs.push_back("Found next to grazes: nothing, as none was found.");
    return;
  }
  double least = 0;
  double most = -1e300;
  double steepest = 0;
  double missed = 0;
  std::size_t followed = 0;
  for (const GrazeRow& row : study.rows) {
    if (!row.followed()) continue;
    ++followed;
    for (const auto& exponent : row.exponents) {
      if (!exponent) continue;
      least = std::min(least, *exponent);
      most = std::max(most, *exponent);
    }
    for (const auto& approaches : row.approaches) {
      steepest = std::max(steepest, std::abs(approaches.back().hit_slope));
      missed = std::max(missed, std::abs(approaches.back().missed_slope));
    }
  }
  const bool right = std::abs(least + 0.5) < 0.05 && std::abs(most + 0.5) < 0.05;
  section.paragraphs.push_back(fmt::format(
      "Found next to grazes: where a wall is only just hit, the slope grows {}. That is so at {} "
      "of {} grazes of the cases, with exponents from {:.3f} to {:.3f} (theory: -1/2) at widths "
      "from {:g} to {:g}; after the others nothing comes that counts before the body rests on a "
      "wall, and the slope is the same on both sides. "
      "Nearest, at {:.0e} of the range, it is up to {:.0f} impacts per rad/s. There it is {:.1f} "
      "at most on the side where the wall is missed. The reach that "
      "comes with a gradient tells the distance of the graze on both sides: from 1e-6 of the range "
      "on it is off by {:.1f} % at most, and below {:.0e} the gradient is called in doubt.",
      right ? "without limit, as theory has it" : "otherwise than theory has it", followed,
      study.rows.size(), least, most, study.plan.widths.back(), study.plan.widths.front(),
      study.plan.distances.back(), steepest, missed, 100 * worst_reach(study, 1e-6), short_reach));
  section.paragraphs.push_back(
      "An impact that is born by a distance d from the graze strikes with a speed like the root of "
      "d. By itself it does not weigh: the surrogate counts it with the power 1 / width of its "
      "speed, so that its slope stays finite up to a width of 1/2. But what follows feels it: the "
      "path after it is off by as much, and so is every "
      "later impact, so that the surrogate goes with the root of d, and its slope with the inverse "
      "root, whatever the width: a surrogate smooths the limit from which impacts count, not the "
      "motion. A graze is found by following the time of a strike over the speed to where it "
      "jumps, by bisection down to neighbouring numbers.");
  section.tables.push_back(table_of(study));
  for (std::size_t w = 0; w < study.plan.widths.size(); ++w) {
    section.figures.push_back(slopes_of(study, w));
  }
  section.figures.push_back(reaches_of(study));
}

}  // namespace ricochet::studies::surrogate
