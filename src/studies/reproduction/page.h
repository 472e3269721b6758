#pragma once

#include "src/report/page.h"
#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {

/// The report of a study.
report::Page page_of(const Study& study);

}  // namespace ricochet::studies::reproduction
