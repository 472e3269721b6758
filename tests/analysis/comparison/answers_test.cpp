#include <gmock/gmock.h>

#include "src/analysis/comparison/sections.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;
using testing::EndsWith;
using testing::StartsWith;

Json leading(const char* family, int budget, const char* solver) {
  return {{"family", family},       {"budget", budget}, {"solver", solver},
          {"formulation", "count"}, {"best", 0.5},      {"of", 3}};
}

Json page_of(const char* family, int least, int most) {
  return {{"folder", family},
          {"data", {{"problems", {{{"variables", least}}, {{"variables", most}}}}}}};
}

Json change(const char* changed, const char* setting, double found) {
  return {{"family", "few"}, {"changed", changed}, {"setting", setting}, {"returned", found}};
}

Json comparison() {
  return {{"leaders",
           {leading("few", 30, "near"), leading("few", 300, "rich"), leading("one", 30, "far"),
            leading("many", 30, "large")}},
          {"pages",
           {page_of("few", 2, 8),
            page_of("one", 1, 1),
            page_of("many", 32, 64),
            {{"folder", "elsewhere"}, {"data", Json::object()}}}},
          {"families", {{{"family", "few"}}, {{"family", "one"}}, {{"family", "many"}}}},
          {"map", {{{"solver", "ipopt"}, {"shares", {0.75, nullptr, 0.25}}}}},
          {"changes",
           {change("price of a gradient", "n", 0.5), change("price of a gradient", "measured", 1),
            change("smoothing", "n", 0.1)}}};
}

/// The answer to the problem that begins so.
Json answer_to(const Json& all, const std::string& words) {
  for (const Json& answer : answers_data(all)) {
    if (answer["problem"].get<std::string>().starts_with(words)) return answer;
  }
  throw std::out_of_range(words);
}

TEST(Answers, OnASolverSayWhatWasMeasuredNearest) {
  const Json answer = answer_to(comparison(), "Which solver for 16 variables and 500");
  EXPECT_EQ(
      answer["answer"],
      "Not measured itself; nearest: few (2 to 8 variables, 30 evaluations each): near on the "
      "count formulation (P(best) 0.50 on 3 problems); many (32 to 64 variables, 30 evaluations "
      "each): large on "
      "the "
      "count formulation (P(best) 0.50 on 3 problems).");
  ASSERT_EQ(answer["links"].size(), 2U);
  EXPECT_EQ(answer["links"][1]["to"], "many");
}

TEST(Answers, OnASolverAreTrueForOneProblemAndForNoneSolved) {
  Json all = comparison();
  all["leaders"][0]["best"] = all["leaders"][2]["best"] = nullptr;
  all["leaders"][0]["of"] = all["leaders"][2]["of"] = 1;
  all["leaders"][3]["solver"] = all["leaders"][3]["formulation"] = nullptr;
  const std::string answer = answer_to(all, "Which solver")["answer"];
  EXPECT_THAT(answer, testing::HasSubstr("near on the count formulation (on 1 problem);"));
  EXPECT_THAT(answer, EndsWith("none, as the entry with the least mean rank solved none of "
                               "its runs on 3 problems."));
}

TEST(Answers, OnASolverSayWhatWasMeasuredWhereItWas) {
  Json all = comparison();
  all["pages"][2] = page_of("many", 8, 64);
  const Json answer = answer_to(all, "Which solver");
  EXPECT_THAT(answer["answer"].get<std::string>(), StartsWith("many (8 to 64 variables"));
  EXPECT_EQ(answer["links"].size(), 1U);
}

TEST(Answers, OnGradientsAndFailuresAreShares) {
  EXPECT_THAT(answer_to(comparison(), "What does a gradient buy?")["answer"].get<std::string>(),
              EndsWith(": 50 % to 100 % on few."));
  EXPECT_EQ(answer_to(comparison(), "Where does Ipopt fail?")["answer"],
            "Most of all on many (25 % solved), few (75 % solved), of 2 kinds of problems.");
}

TEST(Answers, AreLeftOutWhereTheDataHaveNone) {
  const Json none = {{"leaders", Json::array()},
                     {"pages", Json::array()},
                     {"families", Json::array()},
                     {"map", Json::array()},
                     {"changes", Json::array()}};
  EXPECT_TRUE(answers_data(none).empty());
}

}  // namespace
}  // namespace ricochet::studies::comparison
