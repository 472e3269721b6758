#include "src/report/site/front_answers.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <map>

#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::HasSubstr;

std::map<std::string, FrontExcerpt> by_heading(const std::vector<FrontExcerpt>& all) {
  std::map<std::string, FrontExcerpt> found;
  for (const FrontExcerpt& one : all) found[one.heading] = one;
  return found;
}

TEST(FrontAnswers, OfTheReferenceAnswerWhatAStrangerAsks) {
  const auto reports = found_reports(std::filesystem::path(RICOCHET_SOURCE) / "reports/reference");
  const Front front = front_of(reports);
  const auto first = by_heading(front.answers), further = by_heading(front.question);
  EXPECT_THAT(first.at("How fast may it turn?").text, HasSubstr("1.8 to 12.1 rad/s"));
  EXPECT_THAT(first.at("Does the paper agree?").text, HasSubstr("after fitting 5 parameters"));
  EXPECT_THAT(first.at("Is the paper's fireworks algorithm worth it?").text, HasSubstr(" %"));
  EXPECT_THAT(first.at("Which solver?").text, HasSubstr("No solver is best everywhere"));
  EXPECT_THAT(further.at("Is the paper's 9 rad/s of C1 right?").text, HasSubstr("8.08 rad/s"));
  EXPECT_THAT(further.at("What if C4 had restitution 0.5 in place of 0.9?").text,
              HasSubstr("4.50 rad/s in place of 3.54"));
  EXPECT_THAT(further.at("What are error and cost of RK45 at 1e-6?").text, HasSubstr("µs"));
  EXPECT_THAT(further.at("Which solver copes with missing values?").text, HasSubstr("93 % solved"));
  EXPECT_EQ(further.at("Which solver for 4 variables, 400 evaluations and noise?").links[0].anchor,
            "?variables=4&evaluations=400&trouble=noisy&gradient=yes#chooser");
  EXPECT_EQ(further.at("How do I cite and repeat it?").links[0].folder, "cite");
}

TEST(FrontAnswers, WithoutReportsSayNothingOfThem) {
  const Front front = front_of({});
  EXPECT_TRUE(front.answers.empty());
  EXPECT_EQ(front.question.size(), 1U);
}

}  // namespace
}  // namespace ricochet::site
