#include <gmock/gmock.h>

#include "src/report/site/front_answers.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A row of speed against accuracy; its interval is 10 % to either side.
Json row(const char* family, const char* solver, double share, double evaluations = 5) {
  const bool all = std::string(family) == "all";
  return {{"family", family},
          {"budget", all ? Json() : Json(100)},
          {"largest", true},
          {"solver", solver},
          {"formulation", "count"},
          {"problems", all ? 9 : 4},
          {"complete", true},
          {"evaluations", evaluations},
          {"share", share},
          {"share_lower", share - 0.1},
          {"share_upper", share + 0.1}};
}

FoundReport comparing(const std::vector<Json>& rows) {
  Json data = small_comparison();
  data["speed_accuracy"] = rows;
  return found_comparison(data);
}

std::vector<Json> usual_rows() {
  return {row("top-speed", "fireworks", 0.5),
          row("top-speed", "random-search", 0.3),
          row("top-speed", "pagmo-cmaes", 0.6),
          row("top-speed", "pagmo-cmaes-ipop", 0.7),
          row("top-speed", "nlopt-cobyla", 0.8, 7),
          row("top-speed", "nlopt-direct", 0.8, 3),
          row("top-speed", "continuation-ipopt-tuned", 0.25),
          row("count", "fireworks", 0.8),
          row("count", "random-search", 0.5),
          row("all", "fireworks", 0.2),
          row("all", "random-search", 0.25),
          row("all", "nlopt-cobyla", 0.4)};
}

TEST(PaperAlgorithm, StandsBesideTheBestOfEachKind) {
  const auto answer = paper_algorithm(comparing(usual_rows()));
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->text,
              HasSubstr("The paper's own problem, top-speed (4 problems, 100 evaluations a "
                        "variable): fireworks 50 % (40 to 60), random-search 30 % (20 to 40), "
                        "pagmo-cmaes-ipop 70 % (60 to 80), nlopt-direct 80 % (70 to 90), "
                        "continuation-ipopt-tuned 25 % (15 to 35)."));
  EXPECT_THAT(answer->text,
              HasSubstr("All families (9 problems): fireworks 20 % (10 to 30), random-search 25 % "
                        "(15 to 35), nlopt-cobyla 40 % (30 to 50); none of CMA-ES takes all; none "
                        "of Ipopt takes all."));
  ASSERT_EQ(answer->links.size(), 2U);
  EXPECT_EQ(answer->links[0].folder, "comparison/top-speed");
  EXPECT_EQ(answer->links[1].anchor, "#speed-accuracy");
}

TEST(PaperAlgorithm, SaysFirstWhetherItIsBetterThanChanceAndWhereItWins) {
  EXPECT_EQ(
      paper_algorithm_verdict(comparing(usual_rows())),
      "Not measurably better than random search: on the paper's own problem fireworks solves 50 % "
      "of the runs, random search 30 %, the best CMA-ES, pagmo-cmaes-ipop, 70 %, nlopt-direct 80 % "
      "(4 problems). It wins in 1 of 2 families: count, and beats random search, intervals apart, "
      "in 1: count.");
  std::vector<Json> rows = usual_rows();
  rows[7] = row("count", "fireworks", 0.5);  // as much as random search
  rows[1] = row("top-speed", "random-search", 0.2);
  EXPECT_THAT(paper_algorithm_verdict(comparing(rows)),
              testing::AllOf(testing::StartsWith("Better than random search"),
                             HasSubstr("It wins in none of 2 families, and beats random search, "
                                       "intervals apart, in 1: top-speed.")));
  rows[1] = row("top-speed", "random-search", 0.9);
  EXPECT_THAT(paper_algorithm_verdict(comparing(rows)),
              testing::StartsWith("Worse than random search"));
}

TEST(PaperAlgorithm, NamesTheBestOfItsVariants) {
  FoundReport comparison = comparing(usual_rows());
  Json& rows = comparison.data["speed_accuracy"];
  for (const char* name : {"fireworks", "efwa", "lotfwa"}) {
    comparison.data["solvers"].push_back(
        {{"name", name}, {"outside", false}, {"kind", "fireworks"}});
  }
  rows.push_back(row("top-speed", "efwa", 0.55));
  rows.push_back(row("top-speed", "lotfwa", 0.4));
  EXPECT_THAT(paper_algorithm_verdict(comparison),
              HasSubstr("fireworks solves 50 % of the runs, random search 30 %, the best of 3 "
                        "variants, efwa, 55 %, the best CMA-ES"));
  EXPECT_THAT(paper_algorithm(comparison)->text,
              HasSubstr("random-search 30 % (20 to 40), efwa 55 % (45 to 65), pagmo-cmaes-ipop"));
  rows.push_back(row("top-speed", "fireworks", 0.6));
  EXPECT_THAT(paper_algorithm_verdict(comparison),
              HasSubstr("random search 30 %, the best of 3 variants, the best CMA-ES"));
}

TEST(PaperAlgorithm, IgnoresSmallerBudgetsAndWhoTakesAPart) {
  std::vector<Json> rows = usual_rows();
  rows.push_back(row("top-speed", "nlopt-ags", 1));
  rows.back()["largest"] = false;
  rows.push_back(row("top-speed", "nlopt-mma", 1));
  rows.back()["complete"] = false;
  rows.push_back(row("top-speed", "nlopt-slsqp", 1));
  rows.back()["share_upper"] = nullptr;
  EXPECT_THAT(paper_algorithm(comparing(rows))->text, HasSubstr("nlopt-direct 80 %"));
}

TEST(PaperAlgorithm, IsNotToldOfWhereItDidNotRun) {
  EXPECT_FALSE(paper_algorithm(comparing({})));
  EXPECT_FALSE(paper_algorithm(comparing({row("top-speed", "scan", 1)})));
  const auto answer = paper_algorithm(comparing({row("all", "fireworks", 0.5)}));
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->text, Not(HasSubstr("own problem")));
}

TEST(PaperAlgorithm, IsAnAnswerOfTheFrontPage) {
  const Front front = front_of({comparing(usual_rows())});
  ASSERT_FALSE(front.answers.empty());
  EXPECT_EQ(front.answers[0].heading, "Is the paper's fireworks algorithm worth it?");
}

}  // namespace
}  // namespace ricochet::site
