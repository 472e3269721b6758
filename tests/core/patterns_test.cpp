#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ricochet/error.h"
#include "src/core/names.h"

namespace ricochet {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Patterns, FitTheWholeName) {
  EXPECT_TRUE(fits("top-speed-C1", "top-speed-C[14]"));
  EXPECT_FALSE(fits("top-speed-C2", "top-speed-C[14]"));
  EXPECT_FALSE(fits("top-speed-C1", "top-speed"));
  EXPECT_FALSE(fits("top-speed-C1", ""));
}

TEST(Patterns, OfAListFitWhereOneDoes) {
  EXPECT_TRUE(fits_any("top-speed-C1", {"count-*", "top-*"}));
  EXPECT_FALSE(fits_any("top-speed-C1", {"count-*"}));
  EXPECT_FALSE(fits_any("top-speed-C1", {}));
}

TEST(Patterns, AreReadWithCommasBetween) {
  EXPECT_THAT(split_patterns("count-*,,top-speed-C[14]"),
              ElementsAre("count-*", "top-speed-C[14]"));
  EXPECT_THAT(split_patterns(""), IsEmpty());
}

TEST(Patterns, AreRefusedWhereNothingFits) {
  require_fit({"none", "cob*"}, {"cobyla", "scan"}, "--solvers");
  try {
    require_fit({"coblya"}, {"cobyla", "scan"}, "--solvers");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(HasSubstr("--solvers coblya: nothing fits; "), HasSubstr("cobyla")));
  }
  EXPECT_THROW(require_fit({"*"}, {}, "solvers"), InputError);
}

TEST(Patterns, ThatNothingFitsArePointedToTheList) {
  try {
    require_fit({"simplex"}, {"cobyla", "scan"}, "--solvers", "`ricochet list solvers`");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "--solvers simplex: nothing fits; see `ricochet list solvers`");
  }
}

}  // namespace
}  // namespace ricochet
