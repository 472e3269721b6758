#include <gmock/gmock.h>

#include "src/studies/impact_test/test_scene.h"
#include "tests/studies/impact_test/some_scenes.h"

namespace ricochet::studies::impact_test {
namespace {

using testing::HasSubstr;

TEST(Answer, IsReadInAnyOrderOfImpacts) {
  const Answer answer = answer_in(
      R"({"scene":"a","impacts":[[2,"upper",0.5],[1,"lower",3]],"seconds":0.1,"deepest":1e-5,"end":[0,1]})",
      "a");
  EXPECT_EQ(answer.ending, Ending::answered);
  ASSERT_EQ(answer.impacts.size(), 2U);
  EXPECT_EQ(answer.impacts[0].time, 1);
  EXPECT_EQ(answer.impacts[0].wall, Wall::lower);
  EXPECT_EQ(answer.impacts[1].speed, 0.5);
  EXPECT_EQ(answer.seconds, 0.1);
  EXPECT_EQ(answer.deepest, 1e-5);
}

TEST(Answer, MayBeThatTheToolCannotOrHasFailed) {
  EXPECT_EQ(answer_in(R"({"scene":"a","cannot":"one wall only"})", "a").ending, Ending::cannot);
  EXPECT_EQ(answer_in(R"({"scene":"a","error":"overflow"})", "a").reason, "overflow");
}

TEST(Answer, IsAnErrorIfItIsNone) {
  for (const char* line :
       {"", "Traceback:", "[]", R"({"scene":"a"})", R"({"scene":"b","impacts":[],"seconds":1})",
        R"({"scene":"a","impacts":[[1,"left",1]],"seconds":1})",
        R"({"scene":"a","impacts":[[1,"lower"]],"seconds":1})",
        R"({"scene":"a","impacts":[[1,"lower",null]],"seconds":1})",
        R"({"scene":"a","impacts":[],"seconds":-1})", R"({"scene":"a","error":7})"}) {
    const Answer answer = answer_in(line, "a");
    EXPECT_EQ(answer.ending, Ending::error) << line;
    EXPECT_THAT(answer.reason, HasSubstr("no answer")) << line;
  }
}

TEST(Answer, IsWrittenAsItIsRead) {
  const Answer right = right_answer(with_impacts(3));
  const Answer back = answer_in(line_of(right), "made");
  ASSERT_EQ(back.impacts.size(), 3U);
  EXPECT_EQ(back.impacts[2].time, 3);
  for (const Ending ending : {Ending::cannot, Ending::error, Ending::never}) {
    const Answer answer{"made", ending, "why"};
    EXPECT_EQ(answer_in(line_of(answer), "made").ending, ending);
    EXPECT_EQ(answer_in(line_of(answer), "made").reason, "why");
  }
}

}  // namespace
}  // namespace ricochet::studies::impact_test
