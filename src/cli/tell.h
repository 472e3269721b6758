#pragma once

#include <cstdio>

#include "src/report/drawn_chart.h"
#include "src/report/site/study.h"

namespace ricochet::cli {

/// Prints a study's closing lines. Throws, and the command fails, if a chart of its report could
/// not be drawn.
inline void tell(const studies::Finished& finished) {
  std::fputs(finished.epilogue.c_str(), stdout);
  report::require_none(finished.failures);
}

}  // namespace ricochet::cli
