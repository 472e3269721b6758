#pragma once

#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {

/// The whole study at the coarsest: a second or two.
inline StudyPlan tiny_plan() {
  return {{0.1, 1, 18.0}, 6.0, true, "count-C1,top-speed-C[12]", 2, {5, 20}};
}

}  // namespace ricochet::studies::reproduction
