#pragma once

#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {

/// The whole study at the coarsest: a second or two.
inline StudyPlan tiny_plan() {
  return {{0.1, 1, 18.0}, 6.0, true, {2, Budget{20}}, {"C1", "C2"}};
}

}  // namespace ricochet::studies::reproduction
