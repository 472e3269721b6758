#include "src/studies/dynamics/study.h"

#include <cmath>

#include "src/core/progress.h"
#include "src/studies/dynamics/work.h"

namespace ricochet::studies {

namespace dynamics {
namespace {

using carrier_track::Integrator;
using report::Json;

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
          {evenly(1, 18, 1), 100, evenly(1, 12, 0.1), 32},
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
          {evenly(3, 18, 3), 20, evenly(1, 12, 0.5), 8},
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

void add_methods(const std::vector<Integrator>& integrators, bool contacts, Json& methods) {
  for (const Integrator& integrator : integrators) {
    methods.push_back({{"method", integrator.name},
                       {"contacts", contacts},
                       {"version", integrator.version},
                       {"control", integrator.control}});
  }
}

}  // namespace

Json results_of(const StudyPlan& plan) {
  const std::vector<Integrator> integrators = carrier_track::all_integrators();
  const std::vector<Integrator> penalty = carrier_track::penalty_integrators();
  const auto works = works_in(benchmark_scenes(plan.chaotic_seconds), plan.work, integrators);
  Json data;
  data["restitution"] = data_of(study_laws(plan.measured_stride));
  data["speed"] = speed_data(works);
  data["scenes"] = Json::array();
  for (const SceneWork& work : works) data["scenes"].push_back(data_of(work));
  for (const SceneWork& work : works_in(stiff_benchmark_scenes(), plan.work, penalty)) {
    data["scenes"].push_back(data_of(work));
  }
  data["failure_modes"] = data_of(study_failure_modes(plan.failure_modes, integrators));
  data["stability"] = data_of(study_stability(plan.stability));
  data["lyapunov"] = data_of(study_lyapunov(plan.lyapunov));
  const FidelityData walls = data_of(study_fidelity(plan.fidelity));
  const LevelData levels = data_of(study_levels(plan.levels));
  data["fidelity"] = walls;
  data["levels"] = levels;
  data["level_costs"] = level_costs(walls, levels);
  data["planar"] = planar_need(levels);
  data["thresholds"] = data_of(study_thresholds(plan.thresholds, integrators));
  data["controls"] = {{"per_decade", plan.work.per_decade},
                      {"tolerance", plan.work.tolerance},
                      {"steps", plan.work.steps}};
  data["counts"] = {{"laws", data["restitution"]["laws"].size()},
                    {"methods", integrators.size()},
                    {"scenes", works.size()}};
  data["methods"] = Json::array();
  add_methods(integrators, false, data["methods"]);
  add_methods(penalty, true, data["methods"]);
  for (const std::string& missing : carrier_track::missing_integrators()) {
    data["methods"].push_back({{"method", missing},
                               {"contacts", false},
                               {"version", "missing: built without SUNDIALS"},
                               {"control", ""}});
  }
  return data;
}

}  // namespace dynamics

Study dynamics_study() {
  return {"dynamics", "A coarser study, in seconds", [](bool quick) {
            return dynamics::results_of(quick ? dynamics::quick_plan() : dynamics::full_plan());
          }};
}

}  // namespace ricochet::studies
