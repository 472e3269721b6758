#include "src/studies/advice/knob_grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;
using report::Json;

/// 1 where it is loud, else 0.
int loudness(const Scene& scene, const Limit& limit, double omega) {
  return measured(at_speed(scene, omega), limit.measure) > limit.at_most ? 1 : 0;
}

QuietRange found(const Scene& scene, const Limit& limit, const CoarseScan& scan) {
  SpeedScan loud{1, {}};
  const auto omega = [&](double k) { return scan.lowest * std::pow(scan.ratio, k); };
  const int speeds =
      1 + static_cast<int>(std::floor(std::log(scan.highest / scan.lowest) / std::log(scan.ratio)));
  for (int k = 0; k < speeds; ++k) loud.counts.push_back(loudness(scene, limit, omega(k)));
  QuietRange range;
  const auto first = std::find(loud.counts.begin(), loud.counts.end(), 1);
  if (first == loud.counts.end()) {
    range.to_the_end = true;
    range.quiet = scan.highest;
  } else if (first != loud.counts.begin()) {
    auto louder = static_cast<double>(first - loud.counts.begin());
    double quieter = louder - 1;
    for (int halving = 0; halving < 4; ++halving) {
      const double middle = (quieter + louder) / 2;
      (loudness(scene, limit, omega(middle)) == 1 ? louder : quieter) = middle;
    }
    range.quiet = omega(quieter);
  }
  if (const auto place = best_split(loud, 0.5).speed) {
    range.divide = std::max(omega(*place - 1), range.quiet.value_or(0));
  }
  return range;
}

/// The machine with its knobs at the levels of a combination.
Scene turned(Scene scene, const KnobGrid& grid, std::size_t combination) {
  for (std::size_t k = grid.knobs.size(); k-- > 0;) {
    const std::vector<double>& levels = grid.levels[k];
    const double value = levels[combination % levels.size()];
    combination /= levels.size();
    if (value != grid.knobs[k].own) scene = grid.knobs[k].turned(scene, value);
  }
  return scene;
}

double share_of_point(std::size_t i) {
  return -1 + 2.0 * static_cast<double>(i) / (KnobGrid::points_of_a_line - 1);
}

/// A ten-thousandth is less than what the scan can tell.
Json four_decimals(const std::optional<double>& value) {
  return value ? Json(std::round(*value * 1e4) / 1e4) : Json();
}

Json change_of(const QuietRange& range, const QuietRange& own) {
  if (!range.quiet || !own.quiet) return {};
  return four_decimals(*range.quiet / *own.quiet - 1);
}

Json json_of(const QuietRange& range, const QuietRange& own) {
  constexpr double rpm = 30 / std::numbers::pi;  // of a rad/s
  return {{"quiet", four_decimals(range.quiet)},
          {"rpm", range.quiet ? four_decimals(*range.quiet * rpm) : Json()},
          {"change", change_of(range, own)},
          {"divide", four_decimals(range.divide)},
          {"to_the_end", range.to_the_end},
          {"simulated", range.simulated}};
}

std::string label_of(const Knob& knob) {
  return knob.unit.empty() ? knob.name : knob.name + " [" + knob.unit + "]";
}

Json points_of_line(const KnobGrid& grid, std::size_t k) {
  Json points = Json::array();
  for (const QuietRange& range : grid.lines[k]) {
    Json point = json_of(range, grid.own);
    point["value"] = grid.knobs[k].value(share_of_point(points.size()));
    points.push_back(std::move(point));
  }
  return points;
}

/// Where on its line a knob makes the machine fastest, and where slowest.
Json ends_of_line(const Knob& knob, const Json& points) {
  const auto slower = [](const Json& a, const Json& b) { return a["quiet"] < b["quiet"]; };
  // Of equals the machine's own value is as good as any.
  const Json& own = points.at(KnobGrid::points_of_a_line / 2);
  const Json& most = *std::max_element(points.begin(), points.end(), slower);
  const Json& least = *std::min_element(points.begin(), points.end(), slower);
  return {{"knob", knob.name},
          {"label", label_of(knob)},
          {"unit", knob.unit},
          {"least", knob.least},
          {"own", knob.own},
          {"most", knob.most},
          {"matters", slower(own, most)},
          {"best", slower(own, most) ? most : own},
          {"worst", slower(least, own) ? least : own}};
}

}  // namespace

std::optional<CoarseScan> coarse_scan(const Scene& scene, const QuietSpeed& answer) {
  if (!answer.limit) return std::nullopt;
  const double fastest = answer.options.fastest;
  return CoarseScan{answer.split.speed.value_or(fastest) / 8, fastest,
                    scene.fidelity == Fidelity::compliant ? 1.04 : 1.01};
}

QuietRange quiet_range(const Scene& scene, const Limit& limit, const CoarseScan& scan) {
  try {
    return found(scene, limit, scan);
  } catch (const std::runtime_error&) {  // more impacts or steps than a simulation may have
    QuietRange range;
    range.simulated = false;
    return range;
  }
}

std::optional<KnobGrid> knob_grid(const Scene& scene, const QuietSpeed& answer) {
  const auto scan = coarse_scan(scene, answer);
  if (!scan) return std::nullopt;
  KnobGrid grid{*scan, knobs_of(scene), {}, {}, {}, {}};
  std::size_t combinations = 1;
  for (const Knob& knob : grid.knobs) {
    grid.levels.push_back(knob.levels());
    combinations *= grid.levels.back().size();
  }
  grid.combinations.resize(combinations);
  grid.lines.assign(grid.knobs.size(), std::vector<QuietRange>(KnobGrid::points_of_a_line));
  grid.own = quiet_range(scene, *answer.limit, grid.scan);
  const std::size_t of_lines = grid.knobs.size() * KnobGrid::points_of_a_line;
  tbb::parallel_for(std::size_t{0}, combinations + of_lines, [&](std::size_t i) {
    if (i < combinations) {
      grid.combinations[i] = quiet_range(turned(scene, grid, i), *answer.limit, grid.scan);
      return;
    }
    const std::size_t k = (i - combinations) / KnobGrid::points_of_a_line;
    const std::size_t point = (i - combinations) % KnobGrid::points_of_a_line;
    const Knob& knob = grid.knobs[k];
    const double value = knob.value(share_of_point(point));
    grid.lines[k][point] = quiet_range(value == knob.own ? scene : knob.turned(scene, value),
                                       *answer.limit, grid.scan);
  });
  return grid;
}

Json json_of(const std::optional<KnobGrid>& grid) {
  if (!grid) return {};
  Json knobs = Json::array();
  Json lines = Json::array();
  Json charts = Json::array();
  for (std::size_t k = 0; k < grid->knobs.size(); ++k) {
    const Knob& knob = grid->knobs[k];
    const auto& levels = grid->levels[k];
    const auto own = std::find(levels.begin(), levels.end(), knob.own) - levels.begin();
    knobs.push_back({{"knob", knob.name}, {"unit", knob.unit}, {"own", own}, {"levels", levels}});
    Json points = points_of_line(*grid, k);
    lines.push_back(ends_of_line(knob, points));
    charts.push_back({{"knob", knob.name},
                      {"label", label_of(knob)},
                      {"own", knob.own},
                      {"points", std::move(points)}});
  }
  std::stable_sort(lines.begin(), lines.end(), [](const Json& a, const Json& b) {
    return a["best"]["quiet"] > b["best"]["quiet"];  // null is less than any number
  });
  double top = grid->own.quiet.value_or(0);
  for (const auto& line : grid->lines) {
    for (const QuietRange& range : line) {
      top = std::max({top, range.quiet.value_or(0), range.divide.value_or(0)});
    }
  }
  Json own = json_of(grid->own, grid->own);
  return {{"from", grid->scan.lowest},
          {"to", grid->scan.highest},
          {"step", grid->scan.ratio - 1},
          {"combinations", grid->combinations.size()},
          {"own", std::move(own)},
          {"top", top > 0 ? 1.1 * top : 1},  // of the charts, so that all have one scale
          {"knobs", std::move(knobs)},
          {"lines", std::move(lines)},
          {"charts", std::move(charts)},
          {"answers", report::list_of(grid->combinations, [&](const QuietRange& range) {
             return json_of(range, grid->own);
           })}};
}

}  // namespace ricochet::studies::advice
