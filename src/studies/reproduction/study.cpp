#include "src/studies/reproduction/study.h"

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/questions/count.h"
#include "problems/carrier_track/questions/speed_range.h"
#include "problems/carrier_track/questions/top_speed.h"
#include "solvers/solvers.h"
#include "src/campaign/progress.h"
#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::Json;

constexpr std::size_t path_samples = 600;

std::vector<std::string> every_id() {
  std::vector<std::string> ids;
  for (const Case& c : all_cases()) ids.push_back(c.id);
  return ids;
}

Recording path_at(Scene scene, double omega) {
  scene.omega = omega;
  return record(scene, default_width, path_samples);
}

CaseStudy study_case(const Case& the_case, const Scene& reading, const ScanOptions& options) {
  const Scene scene = scene_of(the_case, reading);
  SpeedScan scan = scan_speeds(scene, options.step, options.highest);
  const Score result = score(scene, the_case.claim, scan, options.stride);
  const LogarithmicScan whole =
      scan_logarithmically([&](double omega) { return count_at(scene, omega); }, slowest_scanned,
                           judged_share * options.highest);
  std::optional<FigurePaths> paths;
  if (const auto& figure = the_case.claim.figure) {
    paths = FigurePaths{path_at(scene, figure->quiet), path_at(scene, figure->loud)};
  }
  return {the_case,        scene, std::move(scan), result, staircase_of(whole, options.highest),
          std::move(paths)};
}

/// What solvers are compared on: two questions of every case.
std::vector<Question> questions_of(const std::vector<std::string>& case_ids) {
  std::vector<Question> questions;
  for (const Machine& machine : all_machines()) {
    if (std::find(case_ids.begin(), case_ids.end(), machine.id) == case_ids.end()) continue;
    questions.push_back(count_question(machine));
    questions.push_back(top_speed_question(machine));
  }
  return questions;
}

}  // namespace

StudyPlan full_plan() {
  return {ScanOptions{1e-3, 10, fastest_speed}, 0.05, false, {15, Budget{100}}, every_id()};
}

StudyPlan quick_plan() {
  return {ScanOptions{1e-2, 1, fastest_speed}, 0.2, true, {5, Budget{100}}, {"C1", "C2", "C9"}};
}

Results results_of(const StudyPlan& plan, std::vector<Solver> solvers) {
  Results results;
  results.plan = plan;
  results.reading = default_reading();
  results.solvers = std::move(solvers);
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
  results.contests = compare(questions_of(plan.compared), results.solvers, plan.comparison);
  return results;
}

Json data_of(const Results& results) {
  const Agreement agreement = agreement_of(results.cases);
  const StudyPlan& plan = results.plan;
  Json solvers = Json::array();
  for (const Solver& solver : results.solvers) {
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
            {"instances", plan.comparison.instances},
            {"evaluations", plan.comparison.budget.evaluations}}},
          {"cases", case_data(results.cases)},
          {"thresholds", threshold_data(results.cases)},
          {"theory", theory_data(results.cases)},
          {"counts", curve_data(results.cases)},
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
            return data_of(results_of(quick ? quick_plan() : full_plan(), all_solvers()));
          }};
}

}  // namespace ricochet::studies
