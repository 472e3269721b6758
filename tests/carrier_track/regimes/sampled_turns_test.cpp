#include "problems/carrier_track/regimes/sampled_turns.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

Scene case_named(const char* name) {
  const Case the_case = find_case(name);
  return scene_of(the_case, default_machine());
}

/// The regime that holds a speed.
const Regime& regime_with(const std::vector<Regime>& regimes, double omega) {
  std::size_t k = 0;
  while (k + 1 < regimes.size() && regimes[k].to < omega) ++k;
  return regimes[k];
}

/// Of machines whose regimes are known: what is simulated is within them, and nearly all of it is
/// reached.
TEST(SampledTurns, AreThoseOfTheRegimes) {
  for (const char* name : {"C1", "C3", "C5", "C9"}) {
    const Scene scene = case_named(name);
    const auto regimes = regimes_of(scene, {2, 6});
    int compared = 0;
    const auto sampled = sampled_turns(scene, 2, 6);
    ASSERT_EQ(sampled.size(), 24U);
    EXPECT_EQ(sampled.front().omega, 2);
    EXPECT_EQ(sampled.back().omega, 6);
    for (const SampledTurns& turns : sampled) {
      const Regime& regime = regime_with(regimes, turns.omega);
      if (!regime.certain) continue;
      ++compared;
      EXPECT_LE(turns.most_per_turn, regime.most_per_turn) << name << ", " << turns.omega;
      EXPECT_NEAR(turns.most_per_turn, regime.most_per_turn, 1) << name << ", " << turns.omega;
    }
    EXPECT_GT(compared, 12) << name;
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
