#include "src/studies/calibration/fit_task.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>

#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

TEST(FitTask, IsMadeOnceAndThenFetched) {
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("fit_task_" + std::to_string(getpid()) + ".toml");
  std::filesystem::remove(file);
  std::atomic<int> made = 0;
  const auto make = [&](const carrier_track::Freedom& freedom, const Search& search,
                        const std::string& left_out) {
    ++made;
    return Fit{freedom.reading, freedom.freed, freedom.held, static_cast<double>(search.seed),
               left_out};
  };
  std::vector<FitTask> tasks;
  for (int seed = 1; seed <= 5; ++seed) {
    Search search = with_evaluations(some_search(1), 7);
    search.seed = seed;
    tasks.push_back({"a kind", make, some_freedom(), search, "C3"});
  }
  for (int round = 0; round < 2; ++round) {
    FitStore store(file);
    const std::vector<Fit> fits = done("making fits", tasks, store);
    ASSERT_EQ(fits.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(fits[i].misfit, static_cast<double>(i + 1));
    EXPECT_EQ(made, 5);
  }
}

}  // namespace
}  // namespace ricochet::studies::calibration
