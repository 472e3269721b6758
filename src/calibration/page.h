#pragma once

#include "src/calibration/study.h"
#include "src/report/page.h"

namespace ricochet::calibration {

/// The story of the study for someone who never saw the paper.
report::Page page_of(const Study& study);

}  // namespace ricochet::calibration
