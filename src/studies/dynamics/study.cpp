#include "src/studies/dynamics/study.h"

#include <chrono>
#include <cmath>

#include "src/campaign/progress.h"

namespace ricochet::studies::dynamics {
namespace {

/// From `first` to `last` in equal steps.
std::vector<double> evenly(double first, double last, double step) {
  std::vector<double> values;
  const auto count = std::lround((last - first) / step);
  for (long k = 0; k <= count; ++k) values.push_back(first + static_cast<double>(k) * step);
  return values;
}

}  // namespace

StudyPlan full_plan() {
  return {12,
          30,
          {2, 1e-12, 1e5},
          {{3, 6, 9, 12, 15, 18}, {1e10, 1e12, 1e14, 1e16, 1e18}},
          full_stability_plan(),
          {evenly(1, 18, 1), 100, evenly(1, 12, 0.1), 32},
          {8, 10000, 30, 8},
          {0.02, {0, 0.25, 0.5, 0.75, 1, 1.5}, 1.5e10, 25}};
}

StudyPlan quick_plan() {
  return {24,
          5,
          {1, 1e-12, 1e3},
          {{6, 12}, {1e10, 1e14, 1e18}},
          quick_stability_plan(),
          {evenly(3, 18, 3), 20, evenly(1, 12, 0.5), 8},
          {3, 1000, 5, 4},
          {1, {0, 0.5, 1}, 1.5e10, 6}};
}

Study make_study(const StudyPlan& plan) {
  const auto start = std::chrono::steady_clock::now();
  Study study;
  study.plan = plan;
  study.laws = study_laws(plan.measured_stride);
  study.integrators = carrier_track::all_integrators();
  const std::vector<BenchmarkScene> arenas = benchmark_scenes(plan.chaotic_seconds);
  {
    Progress progress("work and precision",
                      static_cast<double>(arenas.size() * study.integrators.size()));
    for (const BenchmarkScene& arena : arenas) {
      study.works.push_back(
          work_in(arena, plan.work, study.integrators, [&progress] { progress.advance(1); }));
    }
  }
  study.stability = study_stability(plan.stability);
  study.penalty_integrators = carrier_track::penalty_integrators();
  for (const BenchmarkScene& arena : stiff_benchmark_scenes()) {
    study.stiff_works.push_back(work_in(arena, plan.work, study.penalty_integrators));
  }
  study.fidelity = study_fidelity(plan.fidelity);
  study.lyapunov = study_lyapunov(plan.lyapunov);
  study.hazards = study_failure_modes(plan.hazards, study.integrators);
  study.levels = study_levels(plan.levels);
  study.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return study;
}

}  // namespace ricochet::studies::dynamics
