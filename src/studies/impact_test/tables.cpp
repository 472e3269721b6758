#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "src/studies/impact_test/results.h"
#include "src/studies/impact_test/scene_kinds.h"

/// The tables and charts of the report.
namespace ricochet::studies::impact_test {

namespace {

using report::Chart;
using report::Mark;
using report::Scale;
using report::Series;

/// A simulator at the shown level, over all scenes and by kind.
struct Standing {
  const Measured* measured;
  Tally tally;
  std::vector<std::optional<double>> kinds = {};  ///< missed or invented per 1,000 impacts
  std::string worst = {};                         ///< kind; empty if it loses nothing
};

std::optional<double> wrong_of(const Tally& tally) {
  return tally.per_thousand(tally.missed + tally.invented);
}

template <class Counts>
Tally tally_over(const Results& results, const Measured& measured, const Counts& counts) {
  return tally_of(measured.scores, results.scenes, counts);
}

Tally tally_of_all(const Results& results, const Measured& measured) {
  return tally_over(results, measured, [](const TestScene&) { return true; });
}

Standing standing_of(const Results& results, const Measured& measured) {
  Standing standing{&measured, tally_of_all(results, measured)};
  double most = 0;
  for (const SceneKind& kind : scene_kinds()) {
    const auto wrong = wrong_of(tally_over(
        results, measured, [&](const TestScene& scene) { return scene.kind == kind.name; }));
    standing.kinds.push_back(wrong);
    if (wrong.value_or(0) <= most) continue;
    most = *wrong;
    standing.worst = kind.name;
  }
  return standing;
}

/// ricochet first, then the others in the order of their losses.
std::vector<Standing> standings_of(const Results& results) {
  std::vector<Standing> all;
  for (const Measured& m : results.measured) {
    if (m.level == shown_level(results.plan)) all.push_back(standing_of(results, m));
  }
  std::ranges::stable_sort(all, {}, [](const Standing& one) {
    return std::tuple(one.measured->tool.name != "ricochet", wrong_of(one.tally).value_or(1e9),
                      one.tally.seconds_per_impact.value_or(1e9));
  });
  return all;
}

/// The scores of one of ricochet's own levels at a level of accuracy: its times are a unit.
const std::vector<Score>& unit_of(const Results& results, const std::string& own, Level level) {
  const auto found = std::ranges::find_if(
      results.measured, [&](const Measured& m) { return m.tool.name == own && m.level == level; });
  return found->scores;
}

std::optional<double> ratio_of(const Results& results, const Measured& measured,
                               const std::string& own) {
  return time_ratio(measured.scores, unit_of(results, own, measured.level));
}

std::optional<double> microseconds_of(const Tally& tally) {
  const auto& seconds = tally.seconds_per_impact;
  return seconds ? std::optional(1e6 * *seconds) : std::nullopt;
}

std::string reasons_of(const Measured& measured) {
  const bool both = !measured.cannot.empty() && !measured.failure.empty();
  return measured.cannot + (both ? "; " : "") + measured.failure;
}

/// The simulators at the shown level.
Table tools_table(const Results& results, const std::vector<Standing>& standings) {
  Table table{"tools",
              {{"tool"},
               {"version"},
               {"missed", "", ".1f"},
               {"invented", "", ".1f"},
               {"late", "", ".1f"},
               {"microseconds", "time [us]", ".3g"},
               {"ratio", "time ratio", ".1f"},
               {"scan_ratio", "on scans", ".1f"},
               {"worst", "worst kind"}}};
  for (int d = 1; d <= difficulties; ++d) {
    table.columns.push_back(
        {fmt::format("wrong_{}", d), fmt::format("missed or invented at difficulty {}", d), ".1f"});
  }
  for (const char* name : {"title", "kind", "reasons", "sets", "advice"})
    table.columns.push_back({name});
  for (const Standing& one : standings) {
    const Measured& m = *one.measured;
    const Tally& tally = one.tally;
    std::vector<Value> row = {value_of(m.tool.name),
                              value_of(m.version),
                              value_of(tally.per_thousand(tally.missed)),
                              value_of(tally.per_thousand(tally.invented)),
                              value_of(tally.per_thousand(tally.late)),
                              value_of(microseconds_of(tally)),
                              value_of(ratio_of(results, m, "ricochet")),
                              value_of(ratio_of(results, m, "ricochet-scan")),
                              value_of(one.worst)};
    for (int d = 1; d <= difficulties; ++d) {
      row.push_back(value_of(wrong_of(
          tally_over(results, m, [d](const TestScene& scene) { return scene.difficulty == d; }))));
    }
    for (const std::string& text :
         {m.tool.title, m.tool.kind, reasons_of(m), m.tool.sets, m.tool.advice})
      row.push_back(value_of(text));
    table.add_row(std::move(row));
  }
  return table;
}

/// Every simulator at every level, the tools first.
Table levels_table(const Results& results) {
  Table table{"levels",
              {{"tool"},
               {"level"},
               {"own", "a level of ricochet"},
               {"missed", "", ".1f"},
               {"invented", "", ".1f"},
               {"late", "", ".1f"},
               {"wrong_speed", "", ".1f"},
               {"time_error", "", ".1e"},
               {"penetration", "penetration [m]", ".1e"},
               {"energy", "energy gained, median", "+.0e"},
               {"most_energy", "most", "+.0e"},
               {"microseconds", "time [us]", ".3g"},
               {"cannot"},
               {"errors"},
               {"never"},
               {"setting"}}};
  for (const Measured& m : results.measured) {
    const Tally tally = tally_of_all(results, m);
    table.add(m.tool.name, name_of(m.level), m.own, tally.per_thousand(tally.missed),
              tally.per_thousand(tally.invented), tally.per_thousand(tally.late),
              tally.per_thousand(tally.wrong_speed), tally.time_error, tally.penetration,
              tally.energy_gained, tally.most_energy_gained, microseconds_of(tally), tally.cannot,
              tally.errors, tally.never, m.tool.levels[static_cast<std::size_t>(m.level)]);
  }
  return sorted(std::move(table), {"own"});
}

/// Number of tools that miss or invent an impact in a kind of scenes.
std::ptrdiff_t losing(const std::vector<Standing>& standings, std::size_t kind) {
  return std::ranges::count_if(standings, [&](const Standing& one) {
    return !one.measured->own && one.kinds[kind].value_or(0) > 0;
  });
}

/// The kinds of scenes, with how many tools miss or invent an impact in each.
Table kinds_table(const Results& results, const std::vector<Standing>& standings) {
  Table table{"kinds", {{"kind"}, {"what"}, {"harder"}, {"scenes"}, {"impacts"}, {"lost_by"}}};
  for (std::size_t k = 0; k < scene_kinds().size(); ++k) {
    const SceneKind& kind = scene_kinds()[k];
    int scenes = 0, impacts = 0;
    for (const ScoredScene& s : results.scenes) {
      if (s.scene.kind != kind.name) continue;
      ++scenes;
      impacts += scored_impacts(s.scene, s.truth);
    }
    table.add(kind.name, kind.what, kind.harder, scenes, impacts, losing(standings, k));
  }
  return table;
}

/// What broke the tools, the smallest scenes first.
Table smallest_scenes_table(const Results& results) {
  Table table{"smallest-scenes",
              {{"tool"},
               {"kind"},
               {"scene", "smallest scene"},
               {"impacts"},
               {"from_impacts", "of"},
               {"missed"},
               {"invented"},
               {"answered"}}};
  for (const Broken& broken : results.broken) {
    table.add(broken.tool, broken.kind, words_of(broken.smallest.machine), broken.score.impacts,
              scored_impacts(broken.from.scene, broken.from.truth), broken.score.missed,
              broken.score.invented, broken.score.ending == Ending::answered);
  }
  return sorted(std::move(table), {"impacts"});
}

/// A chart over the time per impact: the levels of each simulator are joined, and the level that is
/// shown has its name.
template <class Get>
Chart over_time(const Results& results, Chart chart, const Get& get) {
  chart.x = {"time per impact [s]", Scale::logarithmic};
  chart.y.scale = Scale::logarithmic;
  chart.width = 860;
  chart.height = 520;
  std::map<std::string, Series> kinds;
  std::string last;
  for (const Measured& m : results.measured) {
    const Tally tally = tally_of_all(results, m);
    const auto value = get(tally);
    if (m.tool.name != last) chart.series.push_back({.label = "", .samples = {}, .pale = true});
    last = m.tool.name;
    if (!tally.seconds_per_impact || !value) continue;
    const double seconds = *tally.seconds_per_impact;
    chart.series.back().samples.push_back({seconds, value});
    Series& dots = kinds[m.tool.kind];
    dots.label = m.tool.kind;
    dots.mark = Mark::points;
    const bool shown = m.level == shown_level(results.plan);
    dots.samples.push_back({seconds, value, {}, shown ? m.tool.name : ""});
  }
  std::erase_if(chart.series, [](const Series& series) { return series.samples.empty(); });
  for (Series& series : chart.series)
    std::ranges::sort(series.samples, {}, &report::Sample::position);
  for (auto& [kind, dots] : kinds) chart.series.push_back(std::move(dots));
  return chart;
}

Chart kinds_chart(const std::vector<Standing>& standings) {
  Chart chart{
      .name = "kinds",
      .x = {"kind"},
      .y = {""},
      .heat_map = report::HeatMap{"per 1,000", {}, report::Range{0, 1000}},
      .width = 900,
      .height = 170 + 22 * static_cast<int>(standings.size()),
      .description = "Heat map of the impacts that each tool loses, over the kind of scene."};
  const auto tools =
      std::ranges::count_if(standings, [](const Standing& one) { return !one.measured->own; });
  chart.title = "Missed or invented per 1,000 impacts, by kind of scene";
  std::ptrdiff_t most = 0;
  for (std::size_t k = 0; k < scene_kinds().size(); ++k) {
    chart.x.categories.push_back(scene_kinds()[k].name);
    if (losing(standings, k) <= most) continue;
    most = losing(standings, k);
    chart.title = fmt::format("{} of {} tools lose impacts in scenes of the kind {}", most, tools,
                              scene_kinds()[k].name);
  }
  for (auto one = standings.rbegin(); one != standings.rend(); ++one) {
    chart.y.categories.push_back(one->measured->tool.name);
    auto& row = chart.heat_map->rows.emplace_back();
    for (const auto& wrong : one->kinds)
      row.push_back(wrong ? std::optional(std::min(*wrong, 1000.0)) : std::nullopt);
  }
  return chart;
}

std::string losses_title(const std::vector<Standing>& standings) {
  const auto told = [](const Standing& one) {
    return fmt::format("{} loses {:.4g}", one.measured->tool.name, wrong_of(one.tally).value_or(0));
  };
  const auto best =
      std::ranges::find_if(standings, [](const Standing& one) { return !one.measured->own; });
  return told(standings.front()) + " of 1,000 impacts" +
         (best == standings.end() ? "" : "; of the tools, " + told(*best));
}

std::string finding_of(const Results& results, const std::vector<Standing>& standings,
                       int impacts) {
  const Tally& own = standings.front().tally;
  std::string text =
      fmt::format("Of {} impacts, ricochet loses {:.3g} per 1,000, and takes {:.2g} µs per impact.",
                  impacts, wrong_of(own).value_or(0), microseconds_of(own).value_or(0));
  std::vector<const Standing*> tools;
  for (const Standing& one : standings)
    if (!one.measured->own && wrong_of(one.tally)) tools.push_back(&one);
  if (tools.empty()) return text;
  const auto clean =
      std::ranges::count_if(tools, [](const Standing* one) { return wrong_of(one->tally) == 0; });
  const auto told = [](const Standing* one) {
    return fmt::format("{}, {:.4g}", one->measured->tool.name, *wrong_of(one->tally));
  };
  return text + fmt::format(
                    " Of {} tools, {} lose none and {} lose some: the best, {} per 1,000 "
                    "in {:.0f} times the time; the worst, {}.",
                    tools.size(), clean, static_cast<std::ptrdiff_t>(tools.size()) - clean,
                    told(tools.front()),
                    ratio_of(results, *tools.front()->measured, "ricochet").value_or(0),
                    told(tools.back()));
}

}  // namespace

report::Results results_of(const Results& results) {
  const std::vector<Standing> standings = standings_of(results);
  int impacts = 0;
  for (const ScoredScene& s : results.scenes) impacts += scored_impacts(s.scene, s.truth);
  const double least_wrong = 500.0 / std::max(impacts, 1);  // half an impact of all, per 1,000
  report::Results all;
  all.set("finding", finding_of(results, standings, impacts));
  all.set("suite", suite_version);
  all.set("seed", results.plan.seed);
  all.set("scenes", results.scenes.size());
  all.set("impacts", impacts);
  all.set("level", name_of(shown_level(results.plan)));
  all.set("lost", wrong_of(standings.front().tally));
  all.set("others",
          std::ranges::count_if(standings, [](const Standing& one) { return !one.measured->own; }));
  all.add(tools_table(results, standings));
  all.add(levels_table(results));
  all.add(kinds_table(results, standings));
  all.add(smallest_scenes_table(results));
  Table missing{"missing", {{"tool"}, {"reason"}}};
  for (const MissingTool& m : results.missing) missing.add(m.tool, m.reason);
  all.add(std::move(missing));
  all.add(over_time(results,
                    {.name = "losses-over-time",
                     .title = losses_title(standings),
                     .y = {"missed or invented, per 1,000"},
                     .lines = {{report::Direction::horizontal, least_wrong, "none"}}},
                    [&](const Tally& tally) {
                      const auto wrong = wrong_of(tally);
                      return wrong ? std::optional(std::max(*wrong, least_wrong)) : wrong;
                    }));
  all.add(over_time(
      results,
      {.name = "error-over-time",
       .title = fmt::format("ricochet's impact times are {:.0e} of the time between impacts off",
                            standings.front().tally.time_error.value_or(0)),
       .y = {"error of time, in mean times between impacts"}},
      [](const Tally& tally) {
        const auto error = tally.time_error;
        return error ? std::optional(std::max(*error, 1e-16)) : error;
      }));
  all.add(kinds_chart(standings));
  return all;
}

}  // namespace ricochet::studies::impact_test
