#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/tool.h"

namespace ricochet::cli {
namespace {

TEST(Certify, WritesAFileThatHoldsWhatWasKnownToo) {
  const auto file = fresh_folder() / "best.toml";
  const Outcome outcome = call("certify --problems top-speed-C3 --out " + file.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("of 1 best values"));
  const std::string text = read(file);
  EXPECT_THAT(text, testing::HasSubstr("[top-speed-C3]"));
  EXPECT_THAT(text, testing::HasSubstr("[count-C1]"));
}

TEST(Certify, WithoutTimeSaysHowToGoOn) {
  const auto file = fresh_folder() / "best.toml";
  const Outcome outcome = call("certify --seconds 0 --out " + file.string());
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, testing::HasSubstr("goes on"));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Certify, RefusesWhatItCannotDo) {
  expect_refusal("certify --problems nothing --out " + (fresh_folder() / "best.toml").string(),
                 "nothing");
  expect_refusal("certify --seconds -3", "--seconds");
}

}  // namespace
}  // namespace ricochet::cli
