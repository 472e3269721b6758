#include "src/studies/reproduction/study.h"

#include <algorithm>
#include <cmath>

#include "embedded/reproduction_plan.h"
#include "embedded/reproduction_quick_plan.h"
#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/questions/speed_range.h"
#include "src/campaign/progress.h"
#include "src/core/patterns.h"
#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::Json;

Recording path_at(Scene scene, double omega) {
  scene.omega = omega;
  return record(scene, default_width, samples_of_a_path);
}

CaseStudy study_case(const Case& the_case, const Scene& reading, const ScanOptions& options) {
  const Scene scene = scene_of(the_case, reading);
  SpeedScan scan = scan_speeds(scene, options.step, options.highest);
  const Score result = score(scene, the_case.claim, scan, options.stride);
  const LogarithmicScan whole =
      scan_logarithmically(scene, slowest_scanned, judged_share * options.highest);
  std::optional<FigurePaths> paths;
  if (const auto& figure = the_case.claim.figure) {
    paths = FigurePaths{path_at(scene, figure->quiet), path_at(scene, figure->loud)};
  }
  return {the_case,        scene, std::move(scan), result, staircase_of(whole, options.highest),
          std::move(paths)};
}

/// The one part of the plan, as it is held without a store.
contest::ContestPlan contest_of(const Plan& plan, const Catalogue& catalogue) {
  const Campaign campaign(plan, catalogue);
  const PlanPart& part = plan.parts.front();
  contest::ContestPlan contest;
  contest.questions = campaign.questions();
  for (const Solver& solver : catalogue.solvers) {
    const auto& chosen = campaign.solvers();
    if (std::any_of(chosen.begin(), chosen.end(),
                    [&](const Solver& c) { return c.name == solver.name; })) {
      contest.solvers.push_back(solver);
    }
  }
  contest.widths = part.widths;
  contest.instances = part.instances;
  contest.budgets = part.budgets;
  contest.limits = plan.limits;
  contest.wants = [forms = part.forms](const Question& question, const Form& form) {
    return fits_any(question.name_of(form), forms);
  };
  return contest;
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

Results results_of(const StudyPlan& plan, const Catalogue& catalogue) {
  Results results;
  results.plan = plan;
  results.reading = default_reading();
  results.contest = contest_of(plan.comparison, catalogue);
  results.groups = contest::groups_of(results.contest, catalogue.families);
  {
    const auto cases = all_cases();
    Progress progress("scanning speeds", static_cast<double>(cases.size()));
    for (const Case& c : cases) {
      results.cases.push_back(study_case(c, results.reading.scene, plan.scan));
      progress.advance(1);
    }
  }
  results.grid = count_grid(results.reading.scene, plan.grid_step, plan.coarse_grid);
  results.trends = trends(results.grid);
  results.standings = contest::hold(results.contest);
  return results;
}

Json data_of(const Results& results) {
  const Agreement agreement = agreement_of(results.cases);
  const StudyPlan& plan = results.plan;
  const PlanPart& compared = plan.comparison.parts.front();
  Json solvers = Json::array();
  for (const Solver& solver : results.contest.solvers) {
    solvers.push_back({{"name", solver.name}, {"version", solver.version}});
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
          {"thresholds", threshold_data(results.cases)},
          {"theory", theory_data(results.cases)},
          {"counts", curve_data(results.cases)},
          {"sharpness", sharpness_data(results.cases)},
          {"steps", step_data(results.cases)},
          {"conclusions", conclusion_data(results.grid, results.trends)},
          {"paths", path_data(results.cases)},
          {"crossing", crossing_data()},
          {"comparison", comparison_data(results)},
          {"reading", reading_data(results.reading)},
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

Study reproduction_study() {
  using namespace reproduction;
  return {"reproduction", "A coarser study, in seconds", [](bool quick) {
            return data_of(results_of(quick ? quick_plan() : full_plan(), whole_catalogue()));
          }};
}

}  // namespace ricochet::studies
