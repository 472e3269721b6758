#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::HasSubstr;

TEST(SiteCommand, WritesASiteAndSaysHowLargeItIs) {
  const auto folder = fresh_folder();
  const auto data = std::string("/verification/data.json");
  std::filesystem::create_directories(folder / "from" / "verification");
  write(folder / "from" / "verification", "data.json",
        read(std::string(RICOCHET_SOURCE "/reports/reference") + data));
  const Outcome outcome =
      call("site " + (folder / "from").string() + " --out " + (folder / "to").string());
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("The site: " + (folder / "to" / "index.html").string()));
  EXPECT_THAT(outcome.out, HasSubstr(" pages, "));
  EXPECT_TRUE(std::filesystem::exists(folder / "to" / "docs" / "index.html"));
}

TEST(SiteCommand, RefusesAFolderOfSomethingElse) {
  const auto folder = fresh_folder();
  write(folder, "letter", "dear");
  expect_refusal("site " RICOCHET_SOURCE "/reports/reference --out " + folder.string(),
                 "must be new, empty or an earlier site");
  expect_refusal("site " + folder.string() + " --out " + (folder / "to").string(),
                 "must be a folder of reports");
}

}  // namespace
}  // namespace ricochet::cli
