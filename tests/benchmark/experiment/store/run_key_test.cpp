#include "src/benchmark/experiment/store/run_key.h"

#include <gtest/gtest.h>

namespace ricochet {
namespace {

TEST(RunKey, IsNamedWithAllOfIt) {
  const RunKey key = {{"valley", "count", "plain", "fast", 20, "n"}, 3, 4};
  EXPECT_EQ(
      name_of(key),
      "run 4 of fast on instance 3 of valley (formulation count, perturbation plain, budget 20, "
      "gradient price n)");
}

}  // namespace
}  // namespace ricochet
