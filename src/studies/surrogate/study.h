#pragma once

#include "src/report/site/study.h"

namespace ricochet::studies {

/// Can the surrogate and its gradient be trusted? Takes some minutes on two processors.
Study surrogate_study();

}  // namespace ricochet::studies
