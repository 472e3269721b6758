#include "src/dynamics/study.h"

#include <chrono>

#include "src/campaign/progress.h"

namespace ricochet::dynamics {

StudyPlan full_plan() {
  return {12,
          30,
          {2, 1e-12, 1e5},
          {{3, 6, 9, 12, 15, 18}, {1e10, 1e12, 1e14, 1e16, 1e18}},
          full_stability_plan()};
}

StudyPlan quick_plan() {
  return {24, 5, {1, 1e-12, 1e3}, {{6, 12}, {1e10, 1e14, 1e18}}, quick_stability_plan()};
}

Study make_study(const StudyPlan& plan) {
  const auto start = std::chrono::steady_clock::now();
  Study study;
  study.plan = plan;
  study.laws = study_laws(plan.measured_stride);
  study.integrators = carrier_track::all_integrators();
  const std::vector<Arena> arenas = all_arenas(plan.chaotic_seconds);
  {
    Progress progress("work and precision",
                      static_cast<double>(arenas.size() * study.integrators.size()));
    for (const Arena& arena : arenas) {
      study.works.push_back(
          work_in(arena, plan.work, study.integrators, [&progress] { progress.advance(1); }));
    }
  }
  study.stability = study_stability(plan.stability);
  study.penalty_integrators = carrier_track::penalty_integrators();
  for (const Arena& arena : stiff_arenas()) {
    study.stiff_works.push_back(work_in(arena, plan.work, study.penalty_integrators));
  }
  study.fidelity = study_fidelity(plan.fidelity);
  study.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return study;
}

}  // namespace ricochet::dynamics
