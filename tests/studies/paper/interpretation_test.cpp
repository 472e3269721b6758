#include "src/studies/paper/interpretation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "ricochet/error.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;

std::vector<Interpretation> every_interpretation() {
  std::vector<Interpretation> interpretations;
  for (const Interpretation& core : core_interpretations()) {
    interpretations.push_back(core);
    for (const Interpretation& varied : variations(core)) interpretations.push_back(varied);
  }
  return interpretations;
}

TEST(Interpretation, CoversEveryForcingTensionAndWindow) {
  // 3 x 3 x 2, and one other answer to one of seven further questions: 3 + 2 + 1 + 2 + 2 + 1 + 2.
  EXPECT_EQ(core_interpretations().size(), 18U);
  EXPECT_EQ(variations(Interpretation{}).size(), 13U);
  Interpretation in_seconds;
  in_seconds.window = WindowUnit::seconds;
  EXPECT_EQ(variations(in_seconds).size(), 12U);  // turns a to b are turns
}

TEST(Interpretation, HasANameAndADescriptionOfItsOwn) {
  std::set<std::string> names, descriptions;
  for (const Interpretation& r : every_interpretation()) {
    EXPECT_TRUE(names.insert(name_of(r)).second) << name_of(r);
    EXPECT_TRUE(descriptions.insert(description_of(r)).second) << description_of(r);
  }
  EXPECT_EQ(name_of(Interpretation{}), "projected-constant-revolutions");
}

TEST(Interpretation, IsFoundByItsName) {
  for (const Interpretation& r : every_interpretation())
    EXPECT_EQ(find_interpretation(name_of(r)), r);
}

TEST(Interpretation, IsRefusedUnderAnotherNameWithWhatThereIs) {
  try {
    find_interpretation("projected-constant-hours");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("projected-constant-hours"));
    EXPECT_THAT(error.what(), HasSubstr("inward-rotating-seconds"));
    EXPECT_THAT(error.what(), HasSubstr("-peaks-0.1mm"));
  }
}

TEST(Interpretation, IsRefusedIfItsAnswersExcludeEachOther) {
  try {
    find_interpretation("projected-constant-seconds-later-window");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("must be a number of revolutions"));
  }
}

TEST(Interpretation, AnswersTenQuestions) {
  for (const Interpretation& r : every_interpretation()) EXPECT_EQ(answers_of(r).size(), 10U);
  Interpretation r;
  r.normal_force = NormalForce::weight;
  EXPECT_EQ(answers_of(r)[4].question, "friction multiplies");
  EXPECT_EQ(answers_of(r)[4].answer, "weight");
}

TEST(Interpretation, VariesOneAnswerAtATime) {
  const auto base = answers_of(Interpretation{});
  for (const Interpretation& varied : variations(Interpretation{})) {
    const auto answers = answers_of(varied);
    int different = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      different += answers[i].answer != base[i].answer ? 1 : 0;
    }
    EXPECT_EQ(different, 1) << name_of(varied);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
