#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "src/report/text.h"

/// What is committed of the reference report, and of Markdown: small, whole, and as it is written.
namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

const fs::path source = RICOCHET_SOURCE;

std::string committed_text(const std::string& name) {
  std::ifstream stream(source / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What git keeps, or would keep once it is told of what is new; nothing where there is no git.
std::set<std::string> committed_files() {
  std::set<std::string> files;
  const std::string call = "git -C '" + source.string() +
                           "' ls-files -z --cached --others --exclude-standard 2>/dev/null";
  FILE* const pipe = popen(call.c_str(), "r");
  if (pipe == nullptr) return files;
  std::string name;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
    if (c != '\0') {
      name += static_cast<char>(c);
      continue;
    }
    if (fs::exists(source / name)) files.insert(name);
    name.clear();
  }
  pclose(pipe);
  return files;
}

bool in_reference(const std::string& name) {
  return name.starts_with("reports/reference/");
}

class Reference : public testing::Test {
 protected:
  void SetUp() override {
    if (files_.empty()) GTEST_SKIP() << "no git, or no repository";
  }
  const std::set<std::string> files_ = committed_files();
};

TEST_F(Reference, StaysSmall) {
  std::uintmax_t bytes = 0;
  for (const std::string& name : files_) {
    if (in_reference(name)) bytes += fs::file_size(source / name);
  }
  EXPECT_GT(bytes, 1'000'000U);
  EXPECT_LT(bytes, 5'600'000U);
}

TEST_F(Reference, HasItsDataAsAReportWouldWriteThem) {
  int reports = 0;
  for (const std::string& name : files_) {
    if (!in_reference(name) || !name.ends_with("/data.json")) continue;
    const std::string text = committed_text(name);
    using report::Json;
    const Json data = report::data_in(text);
    EXPECT_TRUE(report::json_text(data) == text) << name;
    Json read = data;
    read.update(json_of(report::results_in(data)));
    EXPECT_TRUE(read == data) << name;
    ++reports;
  }
  EXPECT_GT(reports, 15);
}

TEST_F(Reference, HasTheDataOfEveryPage) {
  for (const std::string& name : files_) {
    if (!in_reference(name) || !name.ends_with("/summary.md")) continue;
    const std::string page = fs::path(name).parent_path().filename().string();
    // These are drawn from the data of all others.
    if (page == "reference" || page == "machine" || page == "cite") continue;
    EXPECT_TRUE(files_.contains(fs::path(name).parent_path() / "data.json")) << name;
  }
}

TEST_F(Reference, SaysAtTheFootOfEveryPageHowItWasMade) {
  static const std::regex foot(
      "\nMade on 20[0-9]{2}-[0-9]{2}-[0-9]{2} by ricochet [0-9.]+ \\(.+\\) in [0-9.]+ s, with "
      "[0-9]+ "
      "threads?( on .+)?\\.\n$");
  int pages = 0;
  for (const std::string& name : files_) {
    if (!in_reference(name) || !name.ends_with("/summary.md")) continue;
    if (!files_.contains(fs::path(name).parent_path() / "data.json")) continue;
    EXPECT_TRUE(std::regex_search(committed_text(name), foot)) << name;
    ++pages;
  }
  EXPECT_GT(pages, 15);
}

/// The fastest quiet speed is of the long run; the comparison's problems ask for another.
TEST_F(Reference, CallsTheSpeedOfTheWindowByItsName) {
  int pages = 0;
  for (const std::string& name : files_) {
    const bool of_window = name.starts_with("reports/reference/comparison/") ||
                           name.starts_with("reports/reference/surrogate/");
    if (!of_window || !name.ends_with("/summary.md")) continue;
    EXPECT_EQ(committed_text(name).find("astest quiet speed"), std::string::npos) << name;
    ++pages;
  }
  EXPECT_GT(pages, 10);
}

struct Link {
  std::string file, anchor;
};

/// Where a text's links and pictures lead to, but for other sites and what stands in code.
std::vector<Link> links_in(const std::string& markdown) {
  static const std::regex code("```[^]*?```|`[^`\n]*`");
  static const std::regex target(R"(\]\(([^)\s#]*)(?:#([^)\s]*))?\))");
  static const std::regex elsewhere("[a-z]+:.*");
  const std::string prose = std::regex_replace(markdown, code, "");
  std::vector<Link> links;
  for (std::sregex_iterator it(prose.begin(), prose.end(), target), end; it != end; ++it) {
    if (!std::regex_match((*it)[1].str(), elsewhere)) links.push_back({(*it)[1], (*it)[2]});
  }
  return links;
}

/// The anchors that code hosts make of headings: small letters, digits and hyphens.
std::set<std::string> anchors_in(const std::string& markdown) {
  static const std::regex heading("(?:^|\n)#+ ([^\n]*)");
  std::set<std::string> anchors;
  for (std::sregex_iterator it(markdown.begin(), markdown.end(), heading), end; it != end; ++it) {
    std::string anchor;
    for (const char c : (*it)[1].str()) {
      const auto byte = static_cast<unsigned char>(c);
      if (std::isalnum(byte) != 0 || byte >= 0x80) anchor += static_cast<char>(std::tolower(byte));
      if (c == ' ' || c == '-') anchor += '-';
      if (c == '_') anchor += '_';
    }
    anchors.insert(anchor);
  }
  return anchors;
}

/// The links of a file that lead to nothing that is committed.
std::vector<std::string> dead_links(const std::set<std::string>& files, const std::string& name,
                                    const std::string& markdown) {
  std::set<std::string> folders;
  for (const std::string& file : files) {
    for (fs::path at = fs::path(file).parent_path(); !at.empty(); at = at.parent_path()) {
      folders.insert(at.string());
    }
  }
  std::vector<std::string> dead;
  for (const auto& [file, anchor] : links_in(markdown)) {
    std::string target =
        file.empty() ? name : (fs::path(name).parent_path() / file).lexically_normal().string();
    if (target.ends_with('/')) target.pop_back();
    const bool there = files.contains(target) || folders.contains(target);
    const bool place =
        anchor.empty() ||
        (target.ends_with(".md") &&
         anchors_in(target == name ? markdown : committed_text(target)).contains(anchor));
    if (!there || !place) dead.push_back(file + (anchor.empty() ? "" : "#" + anchor));
  }
  return dead;
}

TEST_F(Reference, HasLinksThatLeadSomewhereOnACodeHost) {
  int pages = 0;
  for (const std::string& name : files_) {
    const bool outside = name.find('/') == std::string::npos || name.starts_with("docs/");
    if (!name.ends_with(".md") || !(outside || in_reference(name))) continue;
    for (const std::string& link : dead_links(files_, name, committed_text(name))) {
      ADD_FAILURE() << name << ": " << link << " leads to nothing that is committed";
    }
    ++pages;
  }
  EXPECT_GT(pages, 20);
}

TEST(DeadLinks, AreToFilesFoldersAndPlacesThatAreNotThere) {
  const std::set<std::string> files = {"a/one.md", "a/b/picture.svg", "CONTRIBUTING.md"};
  const auto dead = [&](const std::string& text) { return dead_links(files, "a/one.md", text); };
  EXPECT_TRUE(dead("![p](b/picture.svg) [b](b) [b](b/) [c](../CONTRIBUTING.md) [x](https://x.org)")
                  .empty());
  EXPECT_TRUE(
      dead("# What it *is*: 3 of 4\n[here](#what-it-is-3-of-4), `[code](nowhere)`").empty());
  EXPECT_EQ(dead("[a](index.html) [b](b/summary.md#there) [c](#nowhere)"),
            (std::vector<std::string>{"index.html", "b/summary.md#there", "#nowhere"}));
}

}  // namespace
}  // namespace ricochet::site
