#pragma once

#include "src/report/site/study.h"

namespace ricochet::studies {

/// What the paper's thresholds are in the long run: the borders between regimes, or counts of the
/// long run, fitted to the paper's claims; and what a formula for them is worth.
Study long_run_study();

}  // namespace ricochet::studies
