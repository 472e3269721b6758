#include <gtest/gtest.h>

#include "solvers/mads.h"

namespace ricochet {
namespace {

TEST(Mesh, GetsFinerByAFactorOfFour) {
  Mesh mesh(2, 1, 1);
  EXPECT_EQ(mesh.spacing(), 1.0 / 16);
  mesh.refine();
  EXPECT_EQ(mesh.spacing(), 1.0 / 64);
}

TEST(Mesh, GetsCoarserAgainUpToItsCoarsest) {
  Mesh mesh(2, 1, 0.5);
  mesh.refine();
  mesh.coarsen();
  EXPECT_EQ(mesh.index(), 2);
  for (int i = 0; i < 5; ++i) mesh.coarsen();
  EXPECT_EQ(mesh.index(), 1);
  EXPECT_EQ(mesh.spacing(), 0.5 / 4);
}

TEST(Mesh, HasTheSameSpacingForAllNegativeIndices) {
  Mesh mesh(0, -3, 0.1);
  for (int i = 0; i < 5; ++i) mesh.coarsen();
  EXPECT_EQ(mesh.index(), -3);
  EXPECT_EQ(mesh.spacing(), 0.1) << "the polls are longer instead: 2^3 times";
}

TEST(Mesh, IsNotRefinedWhereItBeginsCoarserThanItsCoarsest) {
  Mesh mesh(0, 1, 1);
  mesh.coarsen();
  EXPECT_EQ(mesh.index(), 0);
}

}  // namespace
}  // namespace ricochet
