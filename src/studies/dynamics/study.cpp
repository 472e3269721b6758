#include "src/studies/dynamics/study.h"

#include <fmt/format.h>

#include <cmath>

#include "src/core/progress.h"
#include "src/studies/dynamics/work.h"

namespace ricochet::studies {

namespace dynamics {
namespace {

using carrier_track::Integrator;

/// From `first` to `last` in equal steps.
std::vector<double> evenly(double first, double last, double step) {
  std::vector<double> values;
  const auto count = std::lround((last - first) / step);
  for (long k = 0; k <= count; ++k) values.push_back(first + static_cast<double>(k) * step);
  return values;
}

StudyPlan full_plan() {
  return {12,
          30,
          {2, 1e-12, 1e5},
          {{3, 6, 9, 12, 15, 18}, {1e10, 1e12, 1e14, 1e16, 1e18}},
          full_stability_plan(),
          {evenly(1, 18, 1), 100, 32},
          {8, 10000, 30, 8},
          {0.02, {0, 0.25, 0.5, 0.75, 1, 1.5}, 1.5e10, 25},
          {{"C1", "C2", "C3", "C4"},
           0.25,
           1,
           {1e10, 1e12, 1e14, 1e16, 1e18},
           {1e-3, 1e-5, 1e-7, 1e-9, 1e-11},
           {1e-2, 1e-3, 1e-4, 1e-5}}};
}

/// Coarser: seconds.
StudyPlan quick_plan() {
  return {24,
          5,
          {1, 1e-12, 1e3},
          {{6, 12}, {1e10, 1e14, 1e18}},
          quick_stability_plan(),
          {evenly(3, 18, 3), 20, 8},
          {3, 1000, 5, 4},
          {1, {0, 0.5, 1}, 1.5e10, 6},
          {{"C1", "C2"}, 1, 6, {1e14}, {1e-4, 1e-8}, {1e-3}}};
}

std::vector<SceneWork> works_in(const std::vector<BenchmarkScene>& scenes, const WorkPlan& plan,
                                const std::vector<Integrator>& integrators) {
  Progress progress("work and precision", static_cast<double>(scenes.size() * integrators.size()));
  std::vector<SceneWork> works;
  for (const BenchmarkScene& scene : scenes) {
    works.push_back(work_in(scene, plan, integrators, [&progress] { progress.advance(1); }));
  }
  return works;
}

Table methods_table(const std::vector<Integrator>& integrators) {
  Table table{"methods", {{"method"}, {"version"}, {"control", "tolerance or step"}}};
  for (const Integrator& integrator : integrators)
    table.add(integrator.name, integrator.version, integrator.setting);
  for (const std::string& missing : carrier_track::missing_integrators())
    table.add(missing, "missing: built without SUNDIALS", std::nullopt);
  return table;
}

}  // namespace

report::Results results_of(const StudyPlan& plan) {
  const std::vector<Integrator> integrators = between_hard_walls();
  report::Results results;
  add_to(results, study_laws(plan.measured_stride));
  std::vector<SceneWork> works =
      works_in(benchmark_scenes(plan.chaotic_seconds), plan.work, integrators);
  for (SceneWork& work : works_in(stiff_benchmark_scenes(), plan.work, through_walls()))
    works.push_back(std::move(work));
  add_to(results, works);
  add_to(results, study_failure_modes(plan.failure_modes, integrators));
  add_to(results, study_stability(plan.stability));
  add_to(results, study_lyapunov(plan.lyapunov));
  const FidelityStudy walls = study_fidelity(plan.fidelity);
  add_to(results, walls);
  add_to(results, study_levels(plan.levels), walls);
  add_to(results, study_thresholds(plan.thresholds, integrators));
  const auto said = [&](const char* name) { return text_of(*results.value(name)); };
  results.set("finding",
              fmt::format("{} {} {}", said("levels-finding"), said("walls"), said("laws-finding")));
  results.set("per-decade", plan.work.per_decade);
  results.set("tightest-tolerance", plan.work.tolerance);
  results.set("shortest-step", plan.work.steps);
  results.add(methods_table(integrators));
  return results;
}

}  // namespace dynamics

Study dynamics_study() {
  return {"dynamics", "A coarser study, in seconds", [](bool quick) {
            return json_of(
                dynamics::results_of(quick ? dynamics::quick_plan() : dynamics::full_plan()));
          }};
}

}  // namespace ricochet::studies
