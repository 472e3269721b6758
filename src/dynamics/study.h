#pragma once

#include <cstddef>
#include <vector>

#include "src/dynamics/fidelity.h"
#include "src/dynamics/hazards.h"
#include "src/dynamics/levels.h"
#include "src/dynamics/lyapunov.h"
#include "src/dynamics/restitution.h"
#include "src/dynamics/stability.h"
#include "src/dynamics/work.h"

/// The study of the dynamics: contact laws, numerical methods and levels of the model.
namespace ricochet::dynamics {

struct StudyPlan {
  std::size_t measured_stride;  ///< every which restitution is simulated, too
  double chaotic_seconds;       ///< [s], window of the chaotic arena
  WorkPlan work;
  FidelityPlan fidelity;
  StabilityPlan stability;
  LyapunovPlan lyapunov;
  HazardPlan hazards;
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
  std::vector<ArenaWork> works;
  FidelityStudy fidelity;
  StabilityStudy stability;
  std::vector<carrier_track::Integrator> penalty_integrators;
  std::vector<ArenaWork> stiff_works;  ///< by penalty_integrators
  LyapunovStudy lyapunov;
  HazardStudy hazards;
  LevelStudy levels;
  double seconds = 0;  ///< elapsed
};

/// All but the times is the same every time.
Study make_study(const StudyPlan& plan);

}  // namespace ricochet::dynamics
