#pragma once

#include "src/report/page.h"
#include "src/smoothing/study.h"

namespace ricochet::smoothing {

/// The report of the study.
report::Page page_of(const Study& study);

}  // namespace ricochet::smoothing
