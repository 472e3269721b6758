#include <gtest/gtest.h>

#include "tests/cli/tool.h"

namespace ricochet::cli {
namespace {

TEST(Trials, RefuseToGoOnFromAFileOfSomethingElse) {
  const auto folder = fresh_folder();
  write(folder, "fits.toml", "[[fit]]\nkey = 'of a calibration'\n");
  expect_refusal("trials --quick --out " + folder.string(), "fits.toml");
  EXPECT_EQ(read(folder / "fits.toml"), "[[fit]]\nkey = 'of a calibration'\n");
}

}  // namespace
}  // namespace ricochet::cli
