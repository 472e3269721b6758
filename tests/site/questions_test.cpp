#include "src/site/questions.h"

#include <gmock/gmock.h>

#include "tests/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

/// The one whose words begin so.
Json asked(const std::vector<FoundReport>& reports, const std::string& words) {
  for (const Json& question : questions_data(reports)) {
    if (question["question"].get<std::string>().starts_with(words)) return question;
  }
  throw std::out_of_range(words);
}

Json leading(const char* family, int budget, const char* solver) {
  return {
      {"family", family}, {"budget", budget}, {"solver", solver}, {"form", "count"}, {"best", 0.5}};
}

Json asked_family(const char* name, int least, int most) {
  return {
      {"family", name},
      {"budgets", Json::array()},
      {"questions",
       {{{"variables", least}, {"constraints", 0}}, {{"variables", most}, {"constraints", 0}}}}};
}

FoundReport contest_of_sizes() {
  Json data = {
      {"runs", 1},
      {"leaders",
       {leading("few", 30, "near"), leading("few", 300, "rich"), leading("one", 30, "far"),
        leading("many", 30, "large")}},
      {"groups",
       {asked_family("few", 2, 8), asked_family("one", 1, 1), asked_family("many", 32, 64)}},
      {"families", {{{"family", "few"}}, {{"family", "one"}}, {{"family", "many"}}}},
      {"map", {{{"solver", "ipopt"}, {"shares", {0.75, nullptr, 0.25}}}}},
      {"changes",
       {{{"family", "few"}, {"changed", "price of a gradient"}, {"setting", "n"}, {"found", 0.5}},
        {{"family", "few"},
         {"changed", "price of a gradient"},
         {"setting", "measured"},
         {"found", 1.0}},
        {{"family", "few"}, {"changed", "width"}, {"setting", "n"}, {"found", 0.1}}}}};
  return made_up("contest", data, "race");
}

TEST(Questions, OfACaseAreAnsweredByItsThreshold) {
  const Json data = {{"cases", {{"C3", {{"threshold", 12.0}}}}}};
  const Json question = asked({made_up("reproduction", data, "paper")}, "How fast may C3 run?");
  EXPECT_EQ(question["answer"], "12.00 rad/s, 115 rpm.");
  EXPECT_EQ(question["links"][0]["page"], "paper");
  EXPECT_EQ(question["links"][0]["anchor"], "thresholds");
}

TEST(Questions, OfASolverSayWhatWasMeasuredNearest) {
  const Json question = asked({contest_of_sizes()}, "Which solver for 16 variables and 500");
  EXPECT_EQ(
      question["answer"],
      "Not measured itself; nearest: few (2 to 8 variables, 30 evaluations each): near, shown "
      "count (P(best) 0.50); many (32 to 64 variables, 30 evaluations each): large, shown "
      "count (P(best) 0.50).");
  ASSERT_EQ(question["links"].size(), 2U);
  EXPECT_EQ(question["links"][1]["page"], "race/many");
}

TEST(Questions, OfASolverSayWhatWasMeasuredWhereItWas) {
  FoundReport contest = contest_of_sizes();
  contest.data["groups"][2] = asked_family("many", 8, 64);
  const Json question = asked({contest}, "Which solver");
  EXPECT_THAT(question["answer"].get<std::string>(), StartsWith("many (8 to 64 variables"));
  EXPECT_EQ(question["links"].size(), 1U);
}

TEST(Questions, OfGradientsAndOfFailuresAreAnsweredByShares) {
  const std::vector<FoundReport> reports = {contest_of_sizes()};
  EXPECT_THAT(asked(reports, "What does a gradient buy?")["answer"].get<std::string>(),
              EndsWith(": 50 % to 100 % on few."));
  EXPECT_EQ(asked(reports, "Where does Ipopt fail?")["answer"],
            "Most of all on many (25 % solved), few (75 % solved), of 2 kinds of questions.");
}

TEST(Questions, OfThePlanarModelSayHowManyCountsItChanges) {
  const Json data = {
      {"levels",
       {{"directions",
         {{{"tangent", 0.0}, {"wrong", 0.0}}, {{"tangent", 1.5}, {"wrong", 0.25}}}}}}};
  const auto dynamics = made_up("dynamics", data, "motion");
  const auto mine = made_up("advice", Json::object(), "mine");
  const Json question = asked({dynamics, mine}, "Is the planar model needed");
  EXPECT_THAT(question["answer"].get<std::string>(),
              HasSubstr("at most 25 % of the counts, up to a pull across of 1.5 times"));
  EXPECT_EQ(question["links"][1]["page"], "mine");
}

TEST(Questions, AreAskedOnlyWhereAReportAnswers) {
  EXPECT_TRUE(questions_data({}).empty());
  EXPECT_TRUE(
      questions_data({made_up("reproduction", {{"cases", Json::object()}}, "paper")}).empty());
}

}  // namespace
}  // namespace ricochet::site
