#pragma once

#include "src/report/page.h"
#include "src/reproduction/study.h"

namespace ricochet::reproduction {

/// The report of a study.
report::Page page_of(const Study& study);

}  // namespace ricochet::reproduction
