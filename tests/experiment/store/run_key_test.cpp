#include <gtest/gtest.h>

#include "src/experiment/store.h"

namespace ricochet {
namespace {

TEST(RunKey, IsNamedWithAllOfIt) {
  const RunKey key = {{"valley", "count", "plain", "fast", 20, "n"}, 3, 4};
  EXPECT_EQ(
      name_of(key),
      "run 4 of fast on instance 3 of valley (formulation count, perturbation plain, budget 20, "
      "gradient price n)");
}

TEST(RunKey, IsFoundAgainByItsAddress) {
  const RunKey key = {{"valley", "count", "plain", "fast", 20, "measured"}, 3, 4};
  EXPECT_EQ(address_of(key), "valley/count/plain/fast/20/measured/3/4");
  EXPECT_EQ(key_at(address_of(key)), key);
  for (const char* none : {"", "17", "valley/count/plain/fast/20/n/3", "a/b/c/d/20/n/3/4/5",
                           "a/b/c/d/x/n/3/4", "a/b/c/d/20/n/-3/4", "a/b/c/d/20/n/3/4 "}) {
    EXPECT_FALSE(key_at(none)) << none;
  }
}

}  // namespace
}  // namespace ricochet
