#pragma once

#include "src/dynamics/study.h"
#include "src/report/page.h"

namespace ricochet::dynamics {

/// The report of a study.
report::Page page_of(const Study& study);

}  // namespace ricochet::dynamics
