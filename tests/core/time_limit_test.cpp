#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <optional>
#include <string>
#include <thread>

#include "ricochet/evaluator.h"
#include "src/core/in_parallel.h"

namespace ricochet {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

/// Checks as often as it takes to look at the clock.
void check_for_long() {
  for (int i = 0; i < 1000; ++i) check_time_limit();
}

TEST(TimeLimit, EndsWorkWhenItIsReached) {
  EXPECT_NO_THROW(check_for_long());
  {
    TimeLimit limit(1e-9);
    EXPECT_TRUE(limit.is_reached());
    EXPECT_THROW(check_for_long(), TimeLimitReached);
    std::thread([] { EXPECT_NO_THROW(check_for_long()); }).join();
  }
  EXPECT_NO_THROW(check_for_long()) << "it has ended";
  const TimeLimit long_one(none);
  EXPECT_NO_THROW(check_for_long());
}

TEST(TimeLimit, InsideAnotherTheFirstToEndHolds) {
  const TimeLimit outer(1e-9);
  const TimeLimit inner(none);
  EXPECT_THROW(check_for_long(), TimeLimitReached);
}

TEST(TimeLimit, HoldsForSharedWork) {
  const TimeLimit limit(1e-9);
  EXPECT_THROW(in_parallel("work", 100, [](std::size_t) { check_for_long(); }), TimeLimitReached);
  std::atomic<int> stopped = 0;
  in_parallel("work", 100, [&](std::size_t) {
    try {
      check_for_long();
    } catch (const TimeLimitReached&) {
      ++stopped;
    }
  });
  EXPECT_EQ(stopped, 100);
}

TEST(TimeLimit, KnowsHowFarTheWorkIs) {
  const TimeLimit limit(none);
  EXPECT_EQ(limit.stage(), nullptr);
  report_progress("first", 0.25);
  EXPECT_EQ(limit.stage(), std::string("first"));
  EXPECT_EQ(limit.share(), 0.25);
  std::atomic<std::size_t> sum = 0;
  in_parallel("second", 10, [&](std::size_t i) {
    report_progress("part", 0.5);
    sum += i;
  });
  EXPECT_EQ(sum, 45U) << "each once";
  EXPECT_EQ(limit.stage(), std::string("second"));
  EXPECT_EQ(limit.share(), 1);
}

}  // namespace
}  // namespace ricochet
