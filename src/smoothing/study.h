#pragma once

#include "src/smoothing/agreement.h"
#include "src/smoothing/continuity.h"
#include "src/smoothing/gap.h"
#include "src/smoothing/growth.h"
#include "src/smoothing/guidance.h"
#include "src/smoothing/validity.h"

/// The study of the surrogate: whether it, and its gradient, can be trusted.
namespace ricochet::smoothing {

struct StudyPlan {
  GapPlan gap;
  GuidancePlan guidance;
  ValidityPlan validity;
  ContinuityPlan continuity;
  GrowthPlan growth;
  AgreementPlan agreement;
};

/// Everything: some minutes on two processors.
StudyPlan full_plan();

/// Coarser: seconds.
StudyPlan quick_plan();

struct Study {
  StudyPlan plan;
  GapStudy gap;
  GuidanceStudy guidance;
  ValidityStudy validity;
  ContinuityStudy continuity;
  GrowthStudy growth;
  AgreementStudy agreement;
  double seconds = 0;  ///< elapsed
};

/// The same every time, but for the seconds.
Study make_study(const StudyPlan& plan);

}  // namespace ricochet::smoothing
