#pragma once

#include "src/report/page.h"
#include "src/studies/dynamics/study.h"

namespace ricochet::studies::dynamics {

/// The report of a study.
report::Page page_of(const Study& study);

}  // namespace ricochet::studies::dynamics
