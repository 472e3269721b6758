#include "src/studies/reproduction/study.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/questions/count.h"
#include "problems/carrier_track/questions/speed_range.h"
#include "problems/carrier_track/questions/top_speed.h"
#include "src/campaign/progress.h"
#include "src/core/penalty.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

constexpr std::size_t path_samples = 600;

/// Regret that still counts as solved: an integer count must be met, a speed within 0.01 rad/s.
constexpr double count_tolerance = 0.5;
constexpr double speed_tolerance = 0.01;

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

/// Sets the best known values from an exhaustive scan of the case's speeds, from slowest_speed on:
/// the lowest count, and the fastest speed within the quiet limit.
void know_best(std::vector<Problem>& problems, const SpeedScan& scan, double limit) {
  std::optional<double> fewest;
  std::optional<double> fastest;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    if (scan.omega(k) < slowest_speed) continue;
    if (scan.counts[k] <= limit) fastest = scan.omega(k);
    fewest = std::min<double>(fewest.value_or(scan.counts[k]), scan.counts[k]);
  }
  for (Problem& problem : problems) {
    if (problem.constraints == 0) problem.best_known = fewest;
    if (problem.constraints > 0 && fastest) problem.best_known = -*fastest;
  }
}

/// The problem, and all that it becomes at other smoothing widths, under another name.
Problem renamed(Problem problem, const std::string& name) {
  problem.name = name;
  if (problem.smoothed) {
    problem.smoothed = [smoothed = problem.smoothed, name](double width) {
      return renamed(smoothed(width), name);
    };
  }
  return problem;
}

/// All forms under one name, which alone decides about instances and starts: the same for all.
Contest contest_of(const std::string& case_id, Goal goal, std::vector<Form> forms,
                   double tolerance) {
  const std::string name = forms.front().problem.name;
  for (Form& form : forms) form.problem = renamed(std::move(form.problem), name);
  return {case_id, goal, std::move(forms), tolerance};
}

std::vector<Contest> contests_of(const Study& study) {
  std::vector<Contest> contests;
  for (const CaseStudy& c : study.cases) {
    const auto& ids = study.plan.compared;
    if (std::find(ids.begin(), ids.end(), c.the_case.id) == ids.end()) continue;
    const double limit = quiet_limit(c.score.quiet_count);
    const Machine machine{c.the_case.id, c.scene, limit, c.the_case.claim.threshold, ""};
    std::vector<Problem> problems = {
        count_problem(machine), surrogate_problem(machine, default_width),
        top_speed_problem(machine), top_speed_surrogate_problem(machine, default_width)};
    know_best(problems, c.scan, limit);
    contests.push_back(contest_of(c.the_case.id, Goal::count,
                                  {{"count", problems[0]}, {"surrogate", problems[1]}},
                                  count_tolerance));
    contests.push_back(contest_of(c.the_case.id, Goal::top_speed,
                                  {{"count", problems[2]},
                                   {"penalised count", penalised(problems[2], penalty_weight)},
                                   {"surrogate", problems[3]},
                                   {"penalised surrogate", penalised(problems[3], penalty_weight)}},
                                  speed_tolerance));
  }
  return contests;
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
  study.contests = compare(contests_of(study), study.solvers, plan.comparison);
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
