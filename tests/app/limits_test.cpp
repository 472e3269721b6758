#include <gtest/gtest.h>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

TEST(Limits, RefuseToGoOnFromAFileOfSomethingElse) {
  const auto folder = fresh_folder();
  write(folder, "fits.toml", "[scene]\n");
  expect_refusal("limits --quick --out " + folder.string(), "fits.toml");
  EXPECT_EQ(read(folder / "fits.toml"), "[scene]\n");
}

}  // namespace
}  // namespace ricochet::cli
