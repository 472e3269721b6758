#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "ricochet/error.h"
#include "src/studies/calibration/fit.h"
#include "src/studies/paper/loss.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

std::filesystem::path unwritten_file() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  auto file = std::filesystem::path(testing::TempDir()) /
              ("fit_task_" + std::to_string(getpid()) + test->name() + ".toml");
  std::filesystem::remove(file);
  return file;
}

/// Made up: its two fits have the seed and twice the seed for a loss.
FitTask some_task(int seed, std::atomic<int>& made) {
  const carrier_track::Parameterisation parameterisation = some_parameterisation();
  const auto asked = [&](const char* look, double loss) {
    return AskedFit{std::string(look) + std::to_string(seed),
                    parameterisation,
                    {},
                    "options",
                    [loss](const Fit&) { return loss; }};
  };
  return {{asked("half", 2 * seed), asked("whole", seed)},
          [&made, parameterisation, seed] {
            ++made;
            const Fit fit{parameterisation.interpretation,
                          parameterisation.free,
                          parameterisation.held,
                          2.0 * seed,
                          {}};
            Fit better = fit;
            better.loss = seed;
            return std::vector{fit, better};
          },
          static_cast<double>(seed)};
}

TEST(FitTask, IsMadeOnceAndThenFetched) {
  const auto file = unwritten_file();
  std::atomic<int> made = 0;
  std::vector<FitTask> tasks;
  for (int seed = 1; seed <= 5; ++seed) tasks.push_back(some_task(seed, made));
  for (int round = 0; round < 2; ++round) {
    FitStore store(file);
    const auto fits = searched("making fits", tasks, store);
    ASSERT_EQ(fits.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
      ASSERT_EQ(fits[i].size(), 2U);
      EXPECT_EQ(fits[i][0].loss, 2 * static_cast<double>(i + 1));
      EXPECT_EQ(fits_by("the same", tasks, store)[i].loss, static_cast<double>(i + 1));
    }
    EXPECT_EQ(made, 5);
  }
}

TEST(FitTask, OfASearchTellsItsOptionsAndItsLoss) {
  const Search search = some_search(4);
  const FitTask task = fit_task("fit", some_parameterisation(), search, {"C3"});
  ASSERT_EQ(task.asked.size(), 1U);
  EXPECT_EQ(task.asked[0].options, options_of(search));
  const Fit found = task.search().at(0);
  EXPECT_EQ(task.asked[0].loss(found), found.loss);
  EXPECT_EQ(found.constants, fit(some_parameterisation(), search, {"C3"}).constants);
  Search other = search;
  other.seed = 2;
  EXPECT_NE(fit_task("fit", some_parameterisation(), other, {"C3"}).asked[0].name(),
            task.asked[0].name());
  other = search;
  other.local.version = "another";
  EXPECT_NE(fit_task("fit", some_parameterisation(), other, {"C3"}).asked[0].options,
            task.asked[0].options);
}

/// As a user who sets every loss to 0.125.
TEST(FitTask, StopsAllAtAFitThatIsNotBelieved) {
  const auto file = unwritten_file();
  const std::vector<FitTask> tasks = {fit_task("fit", some_parameterisation(), some_search(3))};
  {
    FitStore store(file);
    fits_by("making fits", tasks, store);
  }
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  std::ofstream(file) << std::regex_replace(text.str(), std::regex("loss = [0-9.]+"),
                                            "loss = 0.125");
  FitStore store(file);
  EXPECT_THROW(fits_by("fetching fits", tasks, store), InputError);
}

}  // namespace
}  // namespace ricochet::studies::calibration
