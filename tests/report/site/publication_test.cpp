#include <gmock/gmock.h>

#include <iterator>
#include <regex>

#include "ricochet/error.h"
#include "src/report/site/site.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

class PublishedSite : public TemporaryFolder {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "from" / "verification");
    fs::copy_file(fs::path(RICOCHET_SOURCE) / "reports/reference/verification/data.json",
                  folder_ / "from/verification/data.json");
  }
};

TEST_F(PublishedSite, IsCompleteAndHasNoLinkOutside) {
  const Publication written = publish_site(folder_ / "from", folder_ / "to");
  EXPECT_TRUE(written.failures.empty());
  for (const char* file : {"index.html", "verification/index.html", "cite/index.html",
                           "docs/index.html", "live/index.html", ".nojekyll"}) {
    EXPECT_TRUE(fs::exists(folder_ / "to" / file)) << file;
  }
  static const std::regex link("<a [^>]*href=\"([^\"#?]*)[^\"]*\"");
  std::size_t pages = 0, links = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "to")) {
    if (entry.path().extension() != ".html") continue;
    ++pages;
    std::ifstream stream(entry.path(), std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
      const std::string target = (*it)[1];
      if (target.empty() || target.starts_with("https://")) continue;
      const fs::path there = (entry.path().parent_path() / target).lexically_normal();
      EXPECT_TRUE(there.string().starts_with((folder_ / "to").string())) << it->str();
      EXPECT_TRUE(fs::exists(there)) << entry.path() << ": " << it->str();
      ++links;
    }
  }
  EXPECT_EQ(pages, written.pages);
  EXPECT_GT(links, 100U);
  EXPECT_GT(written.bytes, 500'000U);
}

TEST_F(PublishedSite, IsWrittenAgainOverItself) {
  static_cast<void>(publish_site(folder_ / "from", folder_ / "to"));
  const Publication again = publish_site(folder_ / "from", folder_ / "to");
  EXPECT_TRUE(again.failures.empty());
}

TEST_F(PublishedSite, OverwritesNothingElse) {
  fs::create_directories(folder_ / "mine");
  std::ofstream(folder_ / "mine" / "letter") << "dear";
  EXPECT_THROW(static_cast<void>(publish_site(folder_ / "from", folder_ / "mine")), InputError);
  EXPECT_THROW(static_cast<void>(publish_site(folder_ / "from", folder_ / "from")), InputError);
  EXPECT_THROW(static_cast<void>(publish_site(folder_ / "mine", folder_ / "new")), InputError);
  EXPECT_FALSE(fs::exists(folder_ / "mine/index.html"));
}

}  // namespace
}  // namespace ricochet::site
