#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

TEST(BestValues, WritesAFileThatHoldsWhatWasKnownToo) {
  const auto file = fresh_folder() / "best.toml";
  const Outcome outcome = call("best-values --problems top-speed-C3 --out " + file.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("of 1 best values"));
  const std::string text = read(file);
  EXPECT_THAT(text, testing::HasSubstr("[top-speed-C3]"));
  EXPECT_THAT(text, testing::HasSubstr("[count-C1]"));
}

TEST(BestValues, WithoutTimeSaysHowToGoOn) {
  const auto file = fresh_folder() / "best.toml";
  const Outcome outcome = call("best-values --seconds 0 --out " + file.string());
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, testing::HasSubstr("goes on"));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(BestValues, RefusesWhatItCannotDo) {
  expect_refusal("best-values --problems nothing --out " + (fresh_folder() / "best.toml").string(),
                 "nothing");
  expect_refusal("best-values --seconds -3", "--seconds");
  expect_refusal("best-values --problems profile-2-C1", "did you mean profile-wear-2-C1 or");
}

}  // namespace
}  // namespace ricochet::cli
