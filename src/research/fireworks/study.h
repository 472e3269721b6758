#pragma once

#include "src/report/site/study.h"

namespace ricochet::studies {

/// Compares the fireworks family with published measurements: ten minutes of processor time.
Study fireworks_study();

}  // namespace ricochet::studies
