#pragma once

#include <cstddef>

#include "src/report/site/study.h"
#include "src/studies/dynamics/failure_modes.h"
#include "src/studies/dynamics/fidelity.h"
#include "src/studies/dynamics/lyapunov.h"
#include "src/studies/dynamics/stability.h"
#include "src/studies/dynamics/work.h"

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
report::Results results_of(const StudyPlan& plan);

}  // namespace dynamics

}  // namespace ricochet::studies
