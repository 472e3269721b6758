#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/tool.h"

namespace ricochet::cli {
namespace {

TEST(Calibrate, RefusesWhatItDoesNotKnowBeforeItWorks) {
  expect_refusal("calibrate --reading sideways", "--reading sideways");
  expect_refusal("calibrate --reading projected-constant-seconds --all-readings",
                 "--all-readings stands alone");
  expect_refusal("calibrate --solver magic", "--solver magic");
  expect_refusal("calibrate --seed -1", "--seed -1");
  const auto file = write(fresh_folder(), "file", "mine");
  expect_refusal("calibrate --out " + (file / "report").string(), "file/report");
  EXPECT_EQ(read(file), "mine");
}

TEST(Calibrate, RefusesToGoOnFromAFileOfSomethingElse) {
  const auto folder = fresh_folder();
  write(folder, "fits.toml", "[scene]\n");
  expect_refusal("calibrate --quick --out " + folder.string(), "fits.toml");
  EXPECT_EQ(read(folder / "fits.toml"), "[scene]\n");
}

}  // namespace
}  // namespace ricochet::cli
