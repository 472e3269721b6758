#include "src/research/impact_test/study.h"

#include <fmt/format.h>

#include <algorithm>

#include "ricochet/error.h"

namespace ricochet::studies {

Study impact_test_study(const impact_test::Plan& plan) {
  if (plan.scenes < 1 || plan.scenes > 1'000'000) {
    throw InputError(fmt::format("--scenes {}: must be within 1..1000000", plan.scenes));
  }
  const auto compute = [plan](bool quick) {
    impact_test::Plan chosen = plan;
    if (quick) chosen.scenes = std::min(chosen.scenes, impact_test::quick_scenes);
    return impact_test::data_of(impact_test::impact_test(chosen));
  };
  return {"impact-test", fmt::format("A first look: {} scenes", impact_test::quick_scenes),
          compute};
}

}  // namespace ricochet::studies
