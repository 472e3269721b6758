#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

TEST(Bench, PrintsGoogleBenchmarksOwnJson) {
  const Outcome outcome = call(
      "bench --format json --benchmark_min_time=0.001 "
      "'--benchmark_filter=-memory|complete-scan|regimes/C([5-9]|1.)'");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(json.contains("context"));
  EXPECT_FALSE(json["benchmarks"].empty());
}

TEST(Bench, RefusesWhatGoogleBenchmarkDoesNotKnow) {
  expect_refusal("bench --fast", "--fast");
  expect_refusal("bench --format xml", "--format");
}

}  // namespace
}  // namespace ricochet::cli
