#include "src/studies/reproduction/study.h"

#include <fmt/format.h>

#include <cmath>

#include "embedded/reproduction_plan.h"
#include "embedded/reproduction_quick_plan.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "ricochet/solver.h"
#include "src/core/progress.h"
#include "src/experiment/planned_runs.h"
#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;

Recording path_at(Scene scene, double omega) {
  scene.omega = omega;
  return record(scene, default_smoothing, samples_of_a_path);
}

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

CaseStudy study_case(const Case& the_case, const Scene& interpretation,
                     const ScanOptions& options) {
  const Scene scene = scene_of(the_case, interpretation);
  SpeedScan scan = scan_speeds(scene, options.step, options.highest);
  const Score result = score(scene, the_case.claim, scan, options.stride);
  const LogarithmicScan whole =
      scan_logarithmically(scene, slowest_scanned, judged_share * options.highest);
  std::optional<FigurePaths> paths;
  if (const auto& figure = the_case.claim.figure) {
    paths = FigurePaths{path_at(scene, figure->quiet), path_at(scene, figure->loud)};
  }
  return {the_case,        scene,  borders_of(scene, options.highest),
          std::move(scan), result, staircase_of(whole, options.highest),
          std::move(paths)};
}

/// A store of another plan, program or data is replaced: its runs take seconds.
StoredCampaign opened(const Plan& plan, const Catalogue& catalogue, const ComparisonStore& store) {
  if (std::filesystem::exists(store.file)) Store::open(store.file, Store::For::reading);
  try {
    return stored_campaign(plan, catalogue, store.file, store.provenance);
  } catch (const InputError& error) {
    if (!std::filesystem::remove(store.file)) throw;
    Progress::announce(fmt::format("{}; it is computed again", error.what()));
    return stored_campaign(plan, catalogue, store.file, store.provenance);
  }
}

/// The problems and solvers of the plan. Problems of the literature are left out: compiling them
/// would double the time to the first report.
Catalogue paper_catalogue() {
  return {case_families(), all_solvers(), {}, {}, {}, {}, {}};
}

}  // namespace

StudyPlan full_plan() {
  return {ScanOptions{1e-3, 10, fastest_speed}, 0.05, false,
          plan_from(embedded::reproduction_plan, "reports/plans/reproduction.toml")};
}

StudyPlan quick_plan() {
  return {ScanOptions{1e-2, 1, fastest_speed}, 0.2, true,
          plan_from(embedded::reproduction_quick_plan, "reports/plans/reproduction_quick.toml")};
}

Findings findings_of(const StudyPlan& plan, const Catalogue& catalogue,
                     const ComparisonStore& store) {
  Findings findings;
  findings.plan = plan;
  findings.interpretation = default_interpretation();
  const Scene& scene = findings.interpretation.scene;
  findings.comparison = opened(plan.comparison, catalogue, store);
  {
    const auto cases = all_cases();
    Progress progress("scanning speeds", static_cast<double>(cases.size()));
    for (const Case& c : cases) {
      findings.cases.push_back(study_case(c, scene, plan.scan));
      progress.advance(1);
    }
  }
  findings.grid = count_grid(scene, plan.grid_step, plan.coarse_grid);
  findings.trends = trends(findings.grid);
  findings.maps = restitution_maps(findings.cases);
  findings.levers =
      levers_of(quiet_cases(findings.cases), scene, plan.coarse_grid, plan.scan.highest);
  make_runs(findings.comparison->campaign, {}, findings.comparison->store);
  return findings;
}

report::Results results_of(const Findings& findings) {
  report::Results results;
  add_thresholds(findings, results);
  add_levers(findings, results);
  add_steps(findings.cases, results);
  add_conclusions(findings.grid, findings.trends, results);
  add_theory(findings.cases, results);
  add_bounds(results);
  add_solvers(findings.comparison, results);
  add_interpretation(findings.interpretation, results);
  add_pictures(findings, results);
  const StudyPlan& plan = findings.plan;
  const PlanPart& compared = plan.comparison.parts.front();
  results.set("step", plan.scan.step);
  results.set("highest", plan.scan.highest);
  results.set("grid_step", plan.grid_step);
  results.set("instances", compared.instances);
  results.set("evaluations", compared.budgets.back());
  return results;
}

Agreement agreement_of(const std::vector<CaseStudy>& cases) {
  Agreement agreement;
  std::vector<std::vector<double>> errors;
  for (const CaseStudy& c : cases) {
    if (c.the_case.claim.threshold && c.score.threshold)
      errors.push_back({std::log(*c.score.threshold / *c.the_case.claim.threshold)});
    for (const Example& e : c.score.examples) {
      ++agreement.examples;
      agreement.right += e.right ? 1 : 0;
    }
  }
  agreement.thresholds = static_cast<int>(errors.size());
  if (errors.empty()) return agreement;
  std::vector<double> all;
  for (const auto& error : errors) all.push_back(error.front());
  agreement.relative_error = root_mean_square(all);
  agreement.interval = root_mean_square_interval(errors, 0.95, 10'000, 1);
  return agreement;
}

}  // namespace ricochet::studies::reproduction

namespace ricochet::studies {

Study reproduction_study(const std::filesystem::path& folder, const Provenance& provenance) {
  using namespace reproduction;
  return {
      "reproduction", "A coarser study, in seconds", [=](bool quick) {
        return json_of(results_of(findings_of(quick ? quick_plan() : full_plan(), paper_catalogue(),
                                              {folder / "comparison.sqlite", provenance})));
      }};
}

}  // namespace ricochet::studies
