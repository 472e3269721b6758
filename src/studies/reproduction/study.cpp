#include "src/studies/reproduction/study.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/questions/count.h"
#include "problems/carrier_track/questions/speed_range.h"
#include "problems/carrier_track/questions/top_speed.h"
#include "src/campaign/progress.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

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
  std::optional<FigurePaths> paths;
  if (const auto& figure = the_case.claim.figure) {
    paths = FigurePaths{path_at(scene, figure->quiet), path_at(scene, figure->loud)};
  }
  return {the_case, scene, std::move(scan), result, std::move(paths)};
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

Study make_study(const StudyPlan& plan, std::vector<Solver> solvers) {
  const auto start = std::chrono::steady_clock::now();
  Study study;
  study.plan = plan;
  study.reading = default_reading();
  study.solvers = std::move(solvers);
  {
    const auto cases = all_cases();
    Progress progress("scanning speeds", static_cast<double>(cases.size()));
    for (const Case& c : cases) {
      study.cases.push_back(study_case(c, study.reading.scene, plan.scan));
      progress.advance(1);
    }
  }
  study.grid = count_grid(study.reading.scene, plan.grid_step, plan.coarse_grid);
  study.trends = trends(study.grid);
  study.contests = compare(questions_of(plan.compared), study.solvers, plan.comparison);
  study.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return study;
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
