#pragma once

#include <cstddef>

#include "src/report/site/study.h"
#include "src/research/dynamics/failure_modes.h"
#include "src/research/dynamics/fidelity.h"
#include "src/research/dynamics/levels.h"
#include "src/research/dynamics/lyapunov.h"
#include "src/research/dynamics/stability.h"
#include "src/research/dynamics/thresholds.h"
#include "src/research/dynamics/work.h"

namespace ricochet::studies {

/// Contact laws, numerical methods and levels of the model. About a minute on one processor; times
/// are measured, so nothing runs in parallel.
Study dynamics_study();

namespace dynamics {

struct StudyPlan {
  std::size_t measured_stride;  ///< every how many restitutions one is simulated, too
  double chaotic_seconds;       ///< [s], window of the chaotic scene
  WorkPlan work;
  FidelityPlan fidelity;
  StabilityPlan stability;
  LyapunovPlan lyapunov;
  FailureModePlan failure_modes;
  LevelPlan levels;
  ThresholdPlan thresholds;
};

/// The results are reproducible, except for the times.
report::Json results_of(const StudyPlan& plan);

}  // namespace dynamics
}  // namespace ricochet::studies
