#pragma once

#include <cstddef>
#include <vector>

#include "src/studies/dynamics/failure_modes.h"
#include "src/studies/dynamics/fidelity.h"
#include "src/studies/dynamics/levels.h"
#include "src/studies/dynamics/lyapunov.h"
#include "src/studies/dynamics/restitution.h"
#include "src/studies/dynamics/stability.h"
#include "src/studies/dynamics/work.h"

/// The study of the dynamics: contact laws, numerical methods and levels of the model.
namespace ricochet::studies::dynamics {

struct StudyPlan {
  std::size_t measured_stride;  ///< every which restitution is simulated, too
  double chaotic_seconds;       ///< [s], window of the chaotic arena
  WorkPlan work;
  FidelityPlan fidelity;
  StabilityPlan stability;
  LyapunovPlan lyapunov;
  FailureModePlan hazards;
  LevelPlan levels;
};

/// Everything: half a minute on one processor; times are measured, so one thing at a time.
StudyPlan full_plan();

/// Coarser: seconds.
StudyPlan quick_plan();

struct Study {
  StudyPlan plan;
  std::vector<LawStudy> laws;
  std::vector<carrier_track::Integrator> integrators;
  std::vector<SceneWork> works;
  FidelityStudy fidelity;
  StabilityStudy stability;
  std::vector<carrier_track::Integrator> penalty_integrators;
  std::vector<SceneWork> stiff_works;  ///< by penalty_integrators
  LyapunovStudy lyapunov;
  FailureModeStudy hazards;
  LevelStudy levels;
  double seconds = 0;  ///< elapsed
};

/// All but the times is the same every time.
Study make_study(const StudyPlan& plan);

}  // namespace ricochet::studies::dynamics
