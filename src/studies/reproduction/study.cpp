#include "src/studies/reproduction/study.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "problems/carrier_track/suite/speed_problems.h"
#include "src/core/progress.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;

LongRunBorders borders_of(const Scene& scene, double highest) {
  LongRunBorders borders;
  if (!has_regimes(scene)) return borders;
  bool silent = true, quiet = true;
  for (const Regime& regime : regimes_of(scene, {slowest_speed, highest})) {
    silent = silent && regime.most_per_turn <= 0;
    quiet = quiet && regime.most_per_turn <= quiet_per_turn;
    if (silent) borders.silent = regime.to;
    if (quiet) borders.quiet = regime.to;
    if (regime.least_per_turn <= quiet_per_turn) borders.loud_from = regime.to;
  }
  return borders;
}

}  // namespace

std::vector<CaseStudy> study_cases(const Scene& interpretation, const ScanOptions& options) {
  std::vector<CaseStudy> cases;
  const std::vector<Case> all = all_cases();
  Progress progress("scanning speeds", static_cast<double>(all.size()));
  for (const Case& it : all) {
    const Scene scene = scene_of(it, interpretation);
    SpeedScan scan = scan_speeds(scene, options.step, options.highest);
    const Score result = score(scene, it.claim, scan, options.stride);
    cases.push_back({it, scene, borders_of(scene, options.highest), std::move(scan), result});
    progress.advance(1);
  }
  return cases;
}

report::Results results_of(const StudyPlan& plan) {
  const FittedInterpretation& fitted = default_interpretation();
  const double highest = plan.scan.highest;
  report::Results results;
  const std::vector<CaseStudy> cases = study_cases(fitted.scene, plan.scan);
  add_thresholds(cases, fitted.free.size(), results);
  add_levers(cases, fitted, plan.coarse, highest, results);
  add_steps(cases, results);
  add_conclusions(count_grid(fitted.scene, plan.grid_step, plan.coarse), results);
  add_theory(cases, results);
  add_bounds(results);
  add_interpretation(fitted, results);
  add_pictures(cases, results);
  add_maps(cases, results);
  results.set("step", plan.scan.step);
  results.set("highest", highest);
  results.set("grid_step", plan.grid_step);
  return results;
}

void add_interpretation(const FittedInterpretation& interpretation, report::Results& results) {
  Table table{"parameters", {{"parameter"}, {"value", "", ".4g"}, {"unit"}, {"origin"}}};
  for (const Unknown open : unknowns_of(interpretation.interpretation)) {
    const auto i = static_cast<std::size_t>(open);
    table.add(unknown_parameters()[i].name, interpretation.constants[i],
              unknown_parameters()[i].unit,
              contains(interpretation.free, open) ? "fitted" : "fixed");
  }
  const auto* turns = std::get_if<Revolutions>(&interpretation.scene.window);
  results.set("turns", turns != nullptr ? std::optional(turns->count) : std::nullopt);
  results.set("interpretation", interpretation.name);
  results.set("description", interpretation.description);
  results.set("provenance", interpretation.provenance);
  results.add(std::move(table));
}

Table count_grid(const Scene& interpretation, double step, bool coarse) {
  const std::vector restitutions = coarse
                                       ? std::vector{0.1, 0.3, 0.5, 0.7, 0.9}
                                       : std::vector{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
  const std::vector frictions = coarse ? std::vector{0.1, 0.2, 0.3, 0.4}
                                       : std::vector{0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4};
  const std::vector disturbances =
      coarse ? std::vector{0.0, 0.1, 1.0} : std::vector{0.0, 0.1, 0.3, 1.0};
  Table grid{"grid", columns_named("restitution,friction,disturbance,mean")};
  for (const double disturbance : disturbances)
    for (const double friction : frictions)
      for (const double restitution : restitutions)
        grid.add(restitution, friction, disturbance, 0.0);
  Progress progress("counting over the grid", static_cast<double>(grid.rows.size()));
  tbb::parallel_for(std::size_t{0}, grid.rows.size(), [&](std::size_t i) {
    const Row row = grid[i];
    const Case at{
        "", row.number("restitution"), row.number("friction"), row.number("disturbance"), {}};
    const auto counts = scan_speeds(scene_of(at, interpretation), step, fastest_speed).counts;
    grid.rows[i].back() =
        std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
    progress.advance(1);
  });
  return grid;
}

namespace {

/// How often neighbours on a line rise, or fall.
Value rises(const std::vector<Value>& means) {
  int count = 0;
  for (std::size_t k = 1; k < means.size(); ++k) count += means[k] > means[k - 1];
  return value_of(count);
}
Value falls(const std::vector<Value>& means) {
  return rises({means.rbegin(), means.rend()});
}
Value end_to_end(const std::vector<Value>& means) {
  return *number_in(means.back()) / *number_in(means.front());
}

/// What the paper concludes of the count along one constant.
struct Conclusion {
  const char *name, *claim;
  std::string along;                  ///< with a minus: it falls
  std::vector<std::string> constant;  ///< on a line
};

/// The mean counts without disturbance.
report::Chart grid_chart(const Table& grid) {
  const Table still = where(grid, "disturbance", 0.0);
  report::Chart chart{.name = "grid",
                      .title = "",
                      .x = {.label = "restitution"},
                      .y = {.label = "friction"},
                      .heat_map = report::HeatMap{"mean count"}};
  each_row(aggregated(still, {"restitution"}, {}), [&](const Row& row) {
    chart.x.categories.push_back(fmt::format("{}", row.number("restitution")));
  });
  each_row(still, [&](const Row& row) {
    const std::string friction = fmt::format("{}", row.number("friction"));
    if (chart.y.categories.empty() || chart.y.categories.back() != friction) {
      chart.y.categories.push_back(friction);
      chart.heat_map->rows.emplace_back();
    }
    chart.heat_map->rows.back().emplace_back(row.number("mean"));
  });
  const auto ends = [&](std::size_t k) {
    const auto& row = chart.heat_map->rows[k];
    return fmt::format("{:.2g} to {:.2g} at friction {}", *row.front(), *row.back(),
                       chart.y.categories[k]);
  };
  chart.title = fmt::format("From restitution {} to {} the mean count goes from {}, from {}",
                            chart.x.categories.front(), chart.x.categories.back(), ends(0),
                            ends(chart.y.categories.size() - 1));
  return chart;
}

}  // namespace

void add_conclusions(const Table& grid, report::Results& results) {
  const Conclusion conclusions[] = {
      {"A", "rises with restitution, without disturbance", "restitution", {"friction"}},
      {"B", "falls with friction, without disturbance", "-friction", {"restitution"}},
      {"C",
       "rises with the disturbance, whatever the other parameters",
       "disturbance",
       {"restitution", "friction"}}};
  Table table{"conclusions",
              {{"conclusion"},
               {"claim", "the count"},
               {"agree", "neighbours as claimed"},
               {"disagree", "against"},
               {"weakest", "end to end, least (times)", ".2f"},
               {"strongest", "most (times)", ".2f"}}};
  std::string text;
  for (const Conclusion& it : conclusions) {
    const Table all = it.along == "disturbance" ? grid : where(grid, "disturbance", 0.0);
    const Table lines = aggregated(sorted(all, {it.along}), it.constant,
                                   {{{"agree"}, "mean", rises},
                                    {{"disagree"}, "mean", falls},
                                    {{"ratio"}, "mean", end_to_end}});
    int agree = 0, disagree = 0;
    double weakest = lines[0].number("ratio"), strongest = weakest;
    each_row(lines, [&](const Row& line) {
      agree += static_cast<int>(line.number("agree"));
      disagree += static_cast<int>(line.number("disagree"));
      weakest = std::min(weakest, line.number("ratio"));
      strongest = std::max(strongest, line.number("ratio"));
    });
    table.add(it.name, it.claim, agree, disagree, weakest, strongest);
    text += text.empty() ? "" : "; ";
    text += disagree == 0
                ? fmt::format("({}) holds between all {} neighbours that differ", it.name, agree)
                : fmt::format("({}) fails between {} of {}", it.name, disagree, agree + disagree);
  }
  results.set("conclusions", text + ".");
  results.add(std::move(table));
  results.add(grid_chart(grid));
}

}  // namespace ricochet::studies::reproduction

namespace ricochet::studies {

Study reproduction_study(const std::filesystem::path& folder, const Provenance& provenance) {
  using reproduction::StudyPlan;
  return {"reproduction", "A coarser study, in seconds", [=](bool quick) {
            const StudyPlan plan =
                quick ? StudyPlan{{1e-2, 1}, 0.2, true} : StudyPlan{{1e-3, 10}, 0.05, false};
            report::Results results = reproduction::results_of(plan);
            reproduction::add_solvers(quick, folder / "comparison.sqlite", provenance, results);
            return json_of(results);
          }};
}

}  // namespace ricochet::studies
