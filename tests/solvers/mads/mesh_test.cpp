#include <gtest/gtest.h>

#include "solvers/mads.h"

namespace ricochet {
namespace {

TEST(Mesh, GetsFinerMuchFasterThanThePollGetsSmaller) {
  Mesh mesh;
  EXPECT_EQ(mesh.poll_size(), 1.0 / 4);
  EXPECT_EQ(mesh.spacing(), 1.0 / 16);
  mesh.refine();
  EXPECT_EQ(mesh.poll_size(), 1.0 / 8);
  EXPECT_EQ(mesh.spacing(), 1.0 / 64);
}

TEST(Mesh, GetsCoarserAgainUpToHalfTheBox) {
  Mesh mesh;
  mesh.refine();
  mesh.coarsen();
  EXPECT_EQ(mesh.index(), Mesh().index());
  for (int i = 0; i < 5; ++i) mesh.coarsen();
  EXPECT_EQ(mesh.poll_size(), 1.0 / 2);
}

}  // namespace
}  // namespace ricochet
