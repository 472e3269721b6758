#include <gtest/gtest.h>

#include "src/experiment/run_rows.h"

namespace ricochet {
namespace {

TEST(RepeatedTerminations, KeepTheirOrder) {
  const std::vector<SolverTermination> terminations = {{"a"}, {"a"}, {"b"}, {"a"}};
  const auto few = repeated(terminations);
  ASSERT_EQ(few.size(), 3U);
  EXPECT_EQ(few[0].reason, "a");
  EXPECT_EQ(few[0].starts, 2);
  EXPECT_EQ(expanded(few), terminations);
  EXPECT_TRUE(repeated({}).empty());
}

}  // namespace
}  // namespace ricochet
