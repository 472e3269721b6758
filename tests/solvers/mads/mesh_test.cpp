#include <gtest/gtest.h>

#include "solvers/mads.h"

namespace ricochet {
namespace {

TEST(Mesh, GetsFinerByAFactorOfFour) {
  Mesh mesh;
  EXPECT_EQ(mesh.spacing(), 1.0 / 16);
  mesh.refine();
  EXPECT_EQ(mesh.spacing(), 1.0 / 64);
}

TEST(Mesh, GetsCoarserAgainUpToHalfTheBox) {
  Mesh mesh;
  mesh.refine();
  mesh.coarsen();
  EXPECT_EQ(mesh.index(), Mesh().index());
  for (int i = 0; i < 5; ++i) mesh.coarsen();
  EXPECT_EQ(mesh.spacing(), 1.0 / 4);
}

}  // namespace
}  // namespace ricochet
