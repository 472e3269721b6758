#include "src/store/repeated_exits.h"

#include <gtest/gtest.h>

namespace ricochet {
namespace {

TEST(RepeatedExits, KeepTheirOrder) {
  const std::vector<SolverExit> exits = {{"a"}, {"a"}, {"b"}, {"a"}};
  const auto few = repeated(exits);
  ASSERT_EQ(few.size(), 3U);
  EXPECT_EQ(few[0].reason, "a");
  EXPECT_EQ(few[0].starts, 2);
  EXPECT_EQ(expanded(few), exits);
  EXPECT_TRUE(repeated({}).empty());
}

}  // namespace
}  // namespace ricochet
