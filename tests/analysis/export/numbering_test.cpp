#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "src/analysis/export/formats.h"

namespace ricochet::exports {
namespace {

CampaignDescription of(std::vector<StoredProblem> problems) {
  CampaignDescription description;
  description.problems = std::move(problems);
  return description;
}

TEST(Numbering, BeginsWithTheProblemsThatCocoOpens) {
  const Numbering numbering(of({{"a", "", "", 1, 0, 0, 0, 0, {}},
                                {"b", "", "", 6, 0, 0, 0, 0, {}},
                                {"c", "", "", 10, 0, 0, 0, 0, {}},
                                {"d", "", "", 5, 0, 0, 0, 0, {}}}));
  EXPECT_EQ(numbering.function_id("b"), 1);
  EXPECT_EQ(numbering.function_id("d"), 2);
  EXPECT_EQ(numbering.function_id("a"), 3);
  EXPECT_EQ(numbering.function_id("c"), 4);
}

TEST(Numbering, HasAnotherNameForEveryAlgorithmThatAnyFileMayHave) {
  Numbering numbering(of({}));
  std::set<std::string> names;
  int algorithms = 0;
  for (const char* solver : {"a b", "a_b", "a/b", "", ".a", "-a", "../..", "ä", "a\n\"b\"'"}) {
    for (const std::string& formulation : {std::string("count"), std::string(300, 'f')}) {
      for (const std::int64_t budget : {1, 10}) {
        const std::string name =
            numbering.algorithm({"q", formulation, "plain", solver, budget, "n"});
        EXPECT_TRUE(std::regex_match(name, std::regex("[A-Za-z0-9_+][-A-Za-z0-9._+]{0,99}")))
            << name;
        EXPECT_EQ(numbering.algorithm({"other", formulation, "plain", solver, budget, "n"}), name);
        names.insert(name);
        ++algorithms;
      }
    }
  }
  EXPECT_EQ(static_cast<int>(names.size()), algorithms);
}

}  // namespace
}  // namespace ricochet::exports
