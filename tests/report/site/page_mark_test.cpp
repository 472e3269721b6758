#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "src/report/site/navigation.h"
#include "tests/support/files.h"

namespace ricochet::site {
namespace {

class PageMark : public TemporaryFolder {
 protected:
  std::string put(const std::string& before, const std::string& html) const {
    const auto page = folder_ / "index.html";
    std::ofstream(page) << before;
    put_at(page, "here", html);
    std::ifstream stream(page);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

TEST_F(PageMark, IsWhereTextIsPut) {
  EXPECT_EQ(put("a<!-- here --><!-- /here -->z", "new\n"), "a<!-- here -->\nnew\n<!-- /here -->z");
  EXPECT_EQ(put("a<!-- here -->\nold\n<!-- /here -->z", "new\n"),
            "a<!-- here -->\nnew\n<!-- /here -->z");
}

TEST_F(PageMark, IsNotMissedWhereThereIsNone) {
  EXPECT_EQ(put("a<!-- here -->z", "new"), "a<!-- here -->z");
  EXPECT_EQ(put("a<!-- /here --><!-- here -->z", "new"), "a<!-- /here --><!-- here -->z");
  put_at(folder_ / "none.html", "here", "new");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none.html"));
}

}  // namespace
}  // namespace ricochet::site
