#pragma once

#include "src/experiment/plan.h"
#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {

/// The whole study at the coarsest: a second or two.
inline StudyPlan tiny_plan() {
  return {{0.1, 1, 18.0},
          6.0,
          true,
          plan_from("[[part]]\nproblems = [\"count-C1\", \"top-speed-C[12]\"]\nsolvers = \"*\"\n"
                    "instances = 2\nbudgets = [5, 20]",
                    "tiny")};
}

}  // namespace ricochet::studies::reproduction
