#include "src/studies/calibration/results.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <filesystem>

#include "tests/studies/calibration/tiny_plan.h"

namespace ricochet::studies::calibration {
namespace {

std::filesystem::path fresh_file(const char* name) {
  const auto file = std::filesystem::path(testing::TempDir()) /
                    (std::string("results_") + std::to_string(getpid()) + name);
  std::filesystem::remove(file);
  return file;
}

TEST(Results, RanksInterpretationsHoldsConstantsAndPredicts) {
  const auto file = fresh_file("a.toml");
  FitStore store(file);
  const Results results = calibrate(tiny_plan(), store);
  ASSERT_GE(results.interpretations.size(), 2U + 11 + 5);
  for (std::size_t i = 1; i < results.interpretations.size(); ++i) {
    EXPECT_GE(results.interpretations[i].fit.loss, results.interpretations[i - 1].fit.loss);
  }
  for (std::size_t i = 1; i < results.frontier.size(); ++i) {
    EXPECT_EQ(results.frontier[i].fit.free.size(), results.frontier[i - 1].fit.free.size() - 1);
  }
  for (const RankedFit& r : results.frontier) {
    EXPECT_GE(r.appraisal.criterion, results.frontier[results.chosen].appraisal.criterion);
  }
  // The choice, the default interpretation, the best one, and those as free as the default one.
  ASSERT_GE(results.convergence.size(), 3U + 2);
  ASSERT_LE(results.convergence.size(), 3U + 3);
  ASSERT_EQ(results.converged.size(), results.convergence.size());
  for (std::size_t i = 3; i < results.convergence.size(); ++i) {
    const Convergence& one = results.convergence[i];
    EXPECT_EQ(one.evaluations, one.evaluations == 3 && one.agreed_from() ? 3 : 4);
    EXPECT_NE(one.parameterisation.interpretation,
              results.convergence[1].parameterisation.interpretation);
  }
  EXPECT_EQ(results.convergence[1].parameterisation.free,
            carrier_track::default_interpretation().free);
  for (std::size_t i = 0; i < results.convergence.size(); ++i) {
    ASSERT_FALSE(results.converged[i].empty());
    EXPECT_EQ(results.converged[i].size(), results.convergence[i].as_good().size());
    for (const RankedFit& r : results.converged[i]) {
      EXPECT_LE(r.fit.loss, 1.01 * results.convergence[i].best().loss);
      EXPECT_GE(r.appraisal.criterion, results.converged[i].front().appraisal.criterion);
    }
    EXPECT_GE(results.converged[i].front().appraisal.criterion,
              results.choice().appraisal.criterion);
  }
  EXPECT_EQ(results.predictions.size(), 50U);
  EXPECT_EQ(results.sensitivities.size(), 10U);
  EXPECT_EQ(results.profiles.size(), results.choice().fit.free.size());

  // Goes on from the file, on one thread, to the same.
  const auto written = std::filesystem::last_write_time(file);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  FitStore again(file);
  const Results resumed = calibrate(tiny_plan(), again);
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
  EXPECT_EQ(resumed.choice().fit.constants, results.choice().fit.constants);
  EXPECT_EQ(resumed.predictions[23].predicted, results.predictions[23].predicted);
}

}  // namespace
}  // namespace ricochet::studies::calibration
