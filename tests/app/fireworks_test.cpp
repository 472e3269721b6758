#include <gtest/gtest.h>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

TEST(Fireworks, RefusesAFolderThatCannotBeWrittenBeforeItWorks) {
  const auto file = write(fresh_folder(), "file", "mine");
  expect_refusal("fireworks --out " + (file / "report").string(), "file/report");
  EXPECT_EQ(read(file), "mine");
}

}  // namespace
}  // namespace ricochet::cli
