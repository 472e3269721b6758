#include "src/studies/best_values/question.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/studies/best_values/some_questions.h"

namespace ricochet::studies::best_values {
namespace {

Family family(const std::string& name, const std::string& judged_as, int size) {
  Family result;
  result.name = name;
  result.judged_as = judged_as;
  for (int k = 0; k < size; ++k) {
    result.problems.push_back(stairs());
    result.problems.back().name = name + "-" + std::to_string(k);
  }
  return result;
}

TEST(Question, TakesTheFormsOfOneTruthTogether) {
  const auto questions = questions_of(
      {family("smooth", "exact", 2), family("exact", "exact", 2), family("other", "other", 1)});
  ASSERT_EQ(questions.size(), 3U);
  EXPECT_EQ(questions[1].name, "exact-1");
  ASSERT_EQ(questions[1].forms.size(), 2U);
  EXPECT_EQ(questions[1].forms[0].name, "exact-1");
  EXPECT_EQ(questions[1].forms[1].name, "smooth-1");
  EXPECT_EQ(questions[2].forms.size(), 1U);
}

TEST(Question, RefusesFormsWithoutTheirTruth) {
  EXPECT_THROW(questions_of({family("smooth", "exact", 2)}), std::logic_error);
  EXPECT_THROW(questions_of({family("exact", "exact", 1), family("smooth", "exact", 2)}),
               std::logic_error);
}

}  // namespace
}  // namespace ricochet::studies::best_values
