#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

TEST(Calibrate, RefusesWhatItDoesNotKnowBeforeItWorks) {
  expect_refusal("calibrate --interpretation sideways", "--interpretation sideways");
  expect_refusal("calibrate --interpretation projected-constant-seconds --all-interpretations",
                 "--all-interpretations stands alone");
  expect_refusal("calibrate --solver magic", "--solver magic");
  expect_refusal("calibrate --seed -1", "--seed -1");
  const auto file = write(fresh_folder(), "file", "mine");
  expect_refusal("calibrate --out " + (file / "report").string(), "file/report");
  EXPECT_EQ(read(file), "mine");
}

TEST(Calibrate, RefusesToGoOnFromAFileOfSomethingElse) {
  const auto folder = fresh_folder();
  write(folder, "runs.sqlite", "mine");
  expect_refusal("calibrate --quick --out " + folder.string(), "runs.sqlite");
  EXPECT_EQ(read(folder / "runs.sqlite"), "mine");
}

}  // namespace
}  // namespace ricochet::cli
