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

/// Of a tiny plan, with these readings ranked.
Results results_of(const std::vector<Reading>& readings) {
  Results results;
  results.plan = tiny_plan();
  for (const Reading& r : readings) results.readings.push_back(natural_fit(r));
  results.frontier = {natural_fit(Reading{})};
  return results;
}

/// With a store that holds nothing yet.
std::vector<Convergence> searched(const Results& results) {
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("long_searches_" + std::to_string(getpid()) + ".toml");
  std::filesystem::remove(file);
  FitStore store(file);
  return long_searches(results, store);
}

TEST(LongSearches, TakeEveryReadingOnceAsFreeAsTheDefaultOne) {
  Reading weight, seconds, crossing;
  weight.normal_force = NormalForce::weight;
  seconds.window = WindowUnit::seconds;
  crossing.transition = Transition::crossing;
  Results results = results_of({crossing, Reading{}, weight, seconds});
  results.plan.convergence->readings = 100;
  const auto all = searched(results);
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
  Results results = results_of({Reading{}});
  results.plan.convergence->seeds = seeds;
  const std::vector<Convergence> all = searched(results);
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
