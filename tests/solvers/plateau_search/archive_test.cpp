#include "solvers/plateau_search/archive.h"

#include <gtest/gtest.h>

namespace ricochet::drifting {
namespace {

TEST(Archive, ForetellsByTheNearestPoint) {
  Archive archive(2, 3);
  EXPECT_TRUE(archive.empty());
  archive.add(Vector{{0, 0}}, {1, 0});
  archive.add(Vector{{1, 1}}, {2, 0});
  EXPECT_EQ(archive.foretold(Vector{{0.4, 0.4}}).objective, 1);
  EXPECT_EQ(archive.foretold(Vector{{0.6, 0.6}}).objective, 2);
}

TEST(Archive, ForgetsTheOldest) {
  Archive archive(1, 2);
  for (const double k : {1, 2, 3}) archive.add(Vector{{k}}, {k, 0});
  EXPECT_EQ(archive.foretold(Vector{{0.0}}).objective, 2);
}

}  // namespace
}  // namespace ricochet::drifting
