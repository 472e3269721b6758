#pragma once

#include "src/report/page.h"
#include "src/studies/calibration/study.h"

namespace ricochet::studies::calibration {

/// The story of the study for someone who never saw the paper.
report::Page page_of(const Study& study);

}  // namespace ricochet::studies::calibration
