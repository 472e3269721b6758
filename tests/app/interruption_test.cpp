#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "src/core/files.h"
#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::HasSubstr;

TEST(Interruption, KeepsWhatIsFinishedAndSaysHowToGoOn) {
  const auto file = fresh_folder() / "best.toml";
  Outcome outcome{};
  for (int seconds = 1; seconds < 100; seconds *= 2) {  // a busy machine has nothing yet after one
    outcome = call_interrupted("INT", "best-values --problems 'top-speed-*' --out " + file.string(),
                               seconds);
    if (outcome.err != "ricochet: interrupted\n") break;
  }
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.err, "ricochet: interrupted; finished searches are kept in " + file.string() +
                             ".part: the same command goes on\n");
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Interruption, OfAComparisonThatHasNoRunsYetSaysHowToGoOn) {
  Outcome outcome{};
  for (int seconds = 1; seconds < 100; seconds *= 2) {
    outcome =
        call_interrupted("INT", "compare --out " + (fresh_folder() / "report").string(), seconds);
    if (outcome.err != "ricochet: interrupted\n") break;
  }
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_THAT(outcome.err, testing::EndsWith("ricochet: interrupted; no run was made: the same "
                                             "command starts again\n"));
}

TEST(Interruption, OfAStudyLeavesNoTrace) {
  const auto folder = fresh_folder();
  const Outcome outcome = call_interrupted(
      "TERM", "verify --scenes 10000000 --out " + (folder / "new" / "report").string());
  EXPECT_EQ(outcome.exit_code, 143);
  EXPECT_EQ(outcome.err, "ricochet: interrupted\n");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(FolderLock, HasASecondCallSayThatThereIsAFirst) {
  const auto folder = fresh_folder() / "report";
  const FolderLock first(folder);
  for (const std::string command :
       {"reproduce --quick --out ", "calibrate --quick --out ", "surrogate --quick --out ",
        "report " RICOCHET_SOURCE "/reports/reference/reproduction --out "}) {
    expect_refusal(command + folder.string(), "another ricochet is at work there");
  }
  expect_refusal("best-values --out " + (folder / "best.toml").string(), "another ricochet");
}

}  // namespace
}  // namespace ricochet::cli
