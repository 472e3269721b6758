#pragma once

#include "src/report/page.h"
#include "src/studies/surrogate/study.h"

namespace ricochet::studies::surrogate {

/// The report of the study.
report::Page page_of(const Study& study);

}  // namespace ricochet::studies::surrogate
