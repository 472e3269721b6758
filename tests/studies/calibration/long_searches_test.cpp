#include "src/studies/calibration/long_searches.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "tests/studies/calibration/tiny_plan.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

RankedFit natural_fit(const Reading& reading) {
  return {{reading, open_of(reading), natural_constants(), 50, ""}, {}};
}

TEST(LongSearches, TakeEveryReadingOnceAsFreeAsTheDefaultOne) {
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("long_searches_" + std::to_string(getpid()) + ".toml");
  std::filesystem::remove(file);
  FitStore store(file);
  Results results;
  results.plan = tiny_plan();
  results.plan.convergence->readings = 100;
  Reading weight, seconds, crossing;
  weight.normal_force = NormalForce::weight;
  seconds.window = WindowUnit::seconds;
  crossing.transition = Transition::crossing;
  for (const Reading& r : {crossing, Reading{}, weight, seconds}) {
    results.readings.push_back(natural_fit(r));
  }
  results.frontier = {natural_fit(Reading{})};
  const auto all = long_searches(results, store);
  ASSERT_GT(all.size(), 5U);
  EXPECT_EQ(all[2].freedom.reading, Reading{}) << "the best whose cases share a scene";
  std::vector<Reading> readings = {all[1].freedom.reading};
  for (std::size_t i = 3; i < all.size(); ++i) readings.push_back(all[i].freedom.reading);
  const auto has = [&](const Reading& r) { return std::ranges::count(readings, r); };
  EXPECT_EQ(has(default_reading().reading), 1);
  EXPECT_EQ(has(crossing), 0);
  // At the normal force that the default reading holds, the weight is no other reading.
  EXPECT_EQ(has(weight) + has(Reading{}), 1);
  const auto same =
      std::ranges::find_if(all, [&](const Convergence& c) { return c.freedom.reading == seconds; });
  ASSERT_NE(same, all.end());
  EXPECT_TRUE(contains(same->freedom.freed, Open::seconds));
  EXPECT_EQ(same->freedom.freed.size(), default_reading().freed.size());
}

/// Those that rank readings, from these seeds.
std::vector<Convergence> of_readings(const std::vector<int>& seeds) {
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("long_searches_" + std::to_string(getpid()) + ".toml");
  std::filesystem::remove(file);
  FitStore store(file);
  Results results;
  results.plan = tiny_plan();
  results.plan.convergence->seeds = seeds;
  results.readings = {natural_fit(Reading{})};
  results.frontier = {natural_fit(Reading{})};
  const std::vector<Convergence> all = long_searches(results, store);
  return {all.begin() + 3, all.end()};
}

TEST(LongSearches, OfReadingsAreBriefWhereTheyAgree) {
  const ConvergencePlan plan = *tiny_plan().convergence;
  const auto alike = of_readings({1, 1});
  ASSERT_FALSE(alike.empty());
  for (const Convergence& c : alike) EXPECT_EQ(c.evaluations, plan.reading_evaluations);
  const auto unlike = of_readings({1, 2});
  ASSERT_FALSE(unlike.empty());
  for (const Convergence& c : unlike) EXPECT_EQ(c.evaluations, plan.evaluations);
  for (std::size_t i = 0; i < unlike.size(); ++i) {
    EXPECT_EQ(unlike[i].freedom.reading, alike[i].freedom.reading);
  }
}

}  // namespace
}  // namespace ricochet::studies::calibration
