#pragma once

#include "src/report/site/study.h"
#include "src/research/impact_test/results.h"

namespace ricochet::studies {

/// How many impacts simulators of impacts lose: ricochet, its own levels of the model, and tools.
/// `--quick` takes quick_scenes scenes.
Study impact_test_study(const impact_test::Plan& plan);

namespace impact_test {
inline constexpr int quick_scenes = 220;  ///< five of each kind and difficulty
}

}  // namespace ricochet::studies
