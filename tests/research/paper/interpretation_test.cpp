#include "problems/carrier_track/paper/reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "src/core/error.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;

std::vector<Reading> every_reading() {
  std::vector<Reading> readings;
  for (const Reading& core : core_readings()) {
    readings.push_back(core);
    for (const Reading& varied : variations(core)) readings.push_back(varied);
  }
  return readings;
}

TEST(Reading, CoversEveryForcingTensionAndWindow) {
  // 3 x 3 x 2, and one other answer to one of six further questions: 3 + 2 + 1 + 2 + 2 + 1.
  EXPECT_EQ(core_readings().size(), 18U);
  EXPECT_EQ(variations(Reading{}).size(), 11U);
}

TEST(Reading, HasANameAndADescriptionOfItsOwn) {
  std::set<std::string> names, descriptions;
  for (const Reading& r : every_reading()) {
    EXPECT_TRUE(names.insert(name_of(r)).second) << name_of(r);
    EXPECT_TRUE(descriptions.insert(description_of(r)).second) << description_of(r);
  }
  EXPECT_EQ(name_of(Reading{}), "projected-constant-revolutions");
}

TEST(Reading, IsFoundByItsName) {
  for (const Reading& r : every_reading()) EXPECT_EQ(find_reading(name_of(r)), r);
}

TEST(Reading, IsRefusedUnderAnotherNameWithWhatThereIs) {
  try {
    find_reading("projected-constant-hours");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("projected-constant-hours"));
    EXPECT_THAT(error.what(), HasSubstr("inward-rotating-seconds"));
    EXPECT_THAT(error.what(), HasSubstr("-peaks-0.1mm"));
  }
}

TEST(Reading, AnswersNineQuestions) {
  for (const Reading& r : every_reading()) EXPECT_EQ(answers_of(r).size(), 9U);
  Reading r;
  r.normal_force = NormalForce::weight;
  EXPECT_EQ(answers_of(r)[4].question, "friction multiplies");
  EXPECT_EQ(answers_of(r)[4].answer, "weight");
}

TEST(Reading, VariesOneAnswerAtATime) {
  const auto base = answers_of(Reading{});
  for (const Reading& varied : variations(Reading{})) {
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
