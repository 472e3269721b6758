#include <gtest/gtest.h>

#include "ricochet/evaluator.h"

namespace ricochet {
namespace {

/// Keeps the processor busy for so long [s].
void work(double seconds) {
  Stopwatch stopwatch;
  while (stopwatch.read() < seconds) {
  }
}

TEST(Stopwatch, TellsTheTimeOfThisThread) {
  Stopwatch stopwatch;
  work(0.01);
  EXPECT_GE(stopwatch.read(), 0.01);
}

TEST(Stopwatch, LeavesOutWhatIsToBeLeftOut) {
  Stopwatch stopwatch;
  stopwatch.leave_out([] { work(0.02); });
  EXPECT_LT(stopwatch.read(), 0.01);
}

TEST(Stopwatch, GlancesCatchUpWithinSixtyFour) {
  Stopwatch stopwatch;
  for (int i = 0; i < 100'000; ++i) ASSERT_GE(stopwatch.glance(), 0);
  const double before = stopwatch.read();
  work(1e-3);
  int glances = 0;
  while (stopwatch.glance() <= before) ASSERT_LT(++glances, 64);
  EXPECT_GE(stopwatch.glance(), before + 1e-3);
}

TEST(Stopwatch, ReadsAtTheFirstGlance) {
  Stopwatch stopwatch;
  work(1e-3);
  EXPECT_GE(stopwatch.glance(), 1e-3);
}

}  // namespace
}  // namespace ricochet
