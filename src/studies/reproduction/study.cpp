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
#include "src/report/json.h"
#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;
using report::Json;

Recording path_at(Scene scene, double omega) {
  scene.omega = omega;
  return record(scene, default_smoothing, samples_of_a_path);
}

LongRunBorders borders_of(const Scene& scene, double highest) {
  if (!has_regimes(scene)) return {};
  const RegimeOptions range{slowest_speed, highest};
  return {quiet_up_to(scene, 0, range), quiet_up_to(scene, quiet_per_turn, range)};
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

Results results_of(const StudyPlan& plan, const Catalogue& catalogue,
                   const ComparisonStore& store) {
  Results results;
  results.plan = plan;
  results.interpretation = default_interpretation();
  results.comparison = opened(plan.comparison, catalogue, store);
  {
    const auto cases = all_cases();
    Progress progress("scanning speeds", static_cast<double>(cases.size()));
    for (const Case& c : cases) {
      results.cases.push_back(study_case(c, results.interpretation.scene, plan.scan));
      progress.advance(1);
    }
  }
  results.grid = count_grid(results.interpretation.scene, plan.grid_step, plan.coarse_grid);
  results.trends = trends(results.grid);
  results.maps = restitution_maps(results.cases);
  results.curves = threshold_curves(all_cases(), results.interpretation.scene, plan.coarse_grid,
                                    plan.scan.highest);
  make_runs(results.comparison->campaign, {}, results.comparison->store);
  return results;
}

Json data_of(const Results& results) {
  const Agreement agreement = agreement_of(results.cases);
  const StudyPlan& plan = results.plan;
  const PlanPart& compared = plan.comparison.parts.front();
  Json solvers = Json::array();
  if (results.comparison) {
    solvers = report::list_of(results.comparison->campaign.solvers(), solver_data);
  }
  return {{"agreement",
           {{"thresholds", agreement.thresholds},
            {"error", std::expm1(agreement.relative_error)},
            {"examples", agreement.examples},
            {"right", agreement.right}}},
          {"plan",
           {{"step", plan.scan.step},
            {"highest", plan.scan.highest},
            {"grid_step", plan.grid_step},
            {"instances", compared.instances},
            {"least", compared.budgets.front()},
            {"most", compared.budgets.back()}}},
          {"cases", case_data(results.cases)},
          {"speeds", speed_data(results.cases)},
          {"thresholds", threshold_data(results.cases)},
          {"theory", theory_data(results.cases)},
          {"bounds", bound_data()},
          {"counts", curve_data(results.cases)},
          {"sharpness", sharpness_data(results.cases)},
          {"steps", step_data(results.cases)},
          {"regime_maps", regime_map_data(results.maps)},
          {"restitution_curves", threshold_curve_data(results.curves)},
          {"conclusions", conclusion_data(results.grid, results.trends)},
          {"paths", path_data(results.cases)},
          {"crossing", crossing_data()},
          {"comparison", comparison_data(results.comparison)},
          {"interpretation", interpretation_data(results.interpretation)},
          {"solvers", std::move(solvers)}};
}

Agreement agreement_of(const std::vector<CaseStudy>& cases) {
  Agreement agreement;
  double squares = 0;
  for (const CaseStudy& c : cases) {
    if (c.the_case.claim.threshold && c.score.threshold) {
      ++agreement.thresholds;
      squares += std::pow(std::log(*c.score.threshold / *c.the_case.claim.threshold), 2);
    }
    for (const Example& e : c.score.examples) {
      ++agreement.examples;
      agreement.right += e.right ? 1 : 0;
    }
  }
  if (agreement.thresholds > 0)
    agreement.relative_error = std::sqrt(squares / agreement.thresholds);
  return agreement;
}

}  // namespace ricochet::studies::reproduction

namespace ricochet::studies {

Study reproduction_study(const std::filesystem::path& folder, const Provenance& provenance) {
  using namespace reproduction;
  return {"reproduction", "A coarser study, in seconds", [=](bool quick) {
            return data_of(results_of(quick ? quick_plan() : full_plan(), paper_catalogue(),
                                      {folder / "comparison.sqlite", provenance}));
          }};
}

}  // namespace ricochet::studies
