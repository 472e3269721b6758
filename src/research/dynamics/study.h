#pragma once

#include <cstddef>

#include "src/studies/dynamics/failure_modes.h"
#include "src/studies/dynamics/fidelity.h"
#include "src/studies/dynamics/levels.h"
#include "src/studies/dynamics/lyapunov.h"
#include "src/studies/dynamics/stability.h"
#include "src/studies/dynamics/thresholds.h"
#include "src/studies/dynamics/work.h"
#include "src/studies/study.h"

namespace ricochet::studies {

/// Contact laws, numerical methods and levels of the model. A minute on one processor; times
/// are measured, so one thing at a time.
Study dynamics_study();

namespace dynamics {

struct StudyPlan {
  std::size_t measured_stride;  ///< every which restitution is simulated, too
  double chaotic_seconds;       ///< [s], window of the chaotic scene
  WorkPlan work;
  FidelityPlan fidelity;
  StabilityPlan stability;
  LyapunovPlan lyapunov;
  FailureModePlan failure_modes;
  LevelPlan levels;
  ThresholdPlan thresholds;
};

/// All but the times is the same every time.
report::Json results_of(const StudyPlan& plan);

}  // namespace dynamics
}  // namespace ricochet::studies
