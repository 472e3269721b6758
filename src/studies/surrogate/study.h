#pragma once

#include "src/studies/surrogate/bias.h"
#include "src/studies/surrogate/continuation_study.h"
#include "src/studies/surrogate/continuity.h"
#include "src/studies/surrogate/derivative_check.h"
#include "src/studies/surrogate/gradient_doubt.h"
#include "src/studies/surrogate/growth.h"

/// The study of the surrogate: whether it, and its gradient, can be trusted.
namespace ricochet::studies::surrogate {

struct StudyPlan {
  BiasPlan gap;
  ContinuationPlan guidance;
  GradientDoubtPlan validity;
  ContinuityPlan continuity;
  GrowthPlan growth;
  DerivativeCheckPlan agreement;
};

/// Everything: some minutes on two processors.
StudyPlan full_plan();

/// Coarser: seconds.
StudyPlan quick_plan();

struct Study {
  StudyPlan plan;
  BiasStudy gap;
  ContinuationStudy guidance;
  GradientDoubtStudy validity;
  ContinuityStudy continuity;
  GrowthStudy growth;
  DerivativeCheckStudy agreement;
  double seconds = 0;  ///< elapsed
};

/// The same every time, but for the seconds.
Study make_study(const StudyPlan& plan);

}  // namespace ricochet::studies::surrogate
