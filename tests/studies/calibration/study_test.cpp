#include "src/studies/calibration/study.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "tests/studies/calibration/tiny_study.h"

namespace ricochet::studies::calibration {
namespace {

std::filesystem::path fresh_file(const char* name) {
  const auto file = std::filesystem::path(testing::TempDir()) /
                    (std::string("study_") + std::to_string(getpid()) + name);
  std::filesystem::remove(file);
  return file;
}

TEST(Study, RanksReadingsHoldsConstantsAndPredicts) {
  const auto file = fresh_file("a.toml");
  FitStore store(file);
  const Study study = make_study(tiny_plan(), store);
  ASSERT_GE(study.readings.size(), 2U + 11 + 5);
  for (std::size_t i = 1; i < study.readings.size(); ++i) {
    EXPECT_GE(study.readings[i].fit.misfit, study.readings[i - 1].fit.misfit);
  }
  ASSERT_EQ(study.rankings.size(), 1U);
  EXPECT_GT(study.rankings[0].misfits.size(), 10U);
  EXPECT_EQ(study.rankings[0].misfits.size(), study.rankings[0].readings.size());
  for (std::size_t i = 1; i < study.frontier.size(); ++i) {
    EXPECT_EQ(study.frontier[i].fit.freed.size(), study.frontier[i - 1].fit.freed.size() - 1);
  }
  for (const RankedFit& r : study.frontier) {
    EXPECT_GE(r.appraisal.criterion, study.choice().appraisal.criterion);
  }
  EXPECT_EQ(study.predictions.size(), 10U);
  EXPECT_EQ(study.sensitivities.size(), 10U);
  EXPECT_EQ(study.profiles.size(), study.choice().fit.freed.size());

  // Goes on from the file, on one thread, to the same.
  const auto written = std::filesystem::last_write_time(file);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  FitStore again(file);
  const Study resumed = make_study(tiny_plan(), again);
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
  EXPECT_EQ(resumed.choice().fit.constants, study.choice().fit.constants);
  EXPECT_EQ(resumed.rankings[0].misfits, study.rankings[0].misfits);
  EXPECT_EQ(resumed.predictions[3].predicted, study.predictions[3].predicted);
}

TEST(Study, CountsAMissingPredictionAsAFactorOfTwo) {
  EXPECT_DOUBLE_EQ(prediction_error({{"C1", 9, 9}, {"C2", 2, std::nullopt}}),
                   std::log(2.0) / std::sqrt(2.0));
}

}  // namespace
}  // namespace ricochet::studies::calibration
