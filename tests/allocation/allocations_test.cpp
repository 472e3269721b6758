#include "tests/allocation/allocations.h"

#include <gtest/gtest.h>

#include <new>

namespace ricochet {
namespace {

// NOTE: calls of the operators by name, because a compiler may leave out a new-expression.
TEST(Allocations, CountEveryFormulationOfNew) {
  constexpr std::align_val_t wide{64};
  const std::int64_t before = allocations();
  ::operator delete(::operator new(8));
  EXPECT_EQ(allocations(), before + 1);
  ::operator delete[](::operator new[](8));
  EXPECT_EQ(allocations(), before + 2);
  ::operator delete(::operator new(8, std::nothrow));
  EXPECT_EQ(allocations(), before + 3);
  ::operator delete[](::operator new[](8, std::nothrow));
  EXPECT_EQ(allocations(), before + 4);
  ::operator delete(::operator new(8, wide), wide);
  EXPECT_EQ(allocations(), before + 5);
  ::operator delete[](::operator new[](8, wide), wide);
  EXPECT_EQ(allocations(), before + 6);
  ::operator delete(::operator new(8, wide, std::nothrow), wide);
  EXPECT_EQ(allocations(), before + 7);
  ::operator delete[](::operator new[](8, wide, std::nothrow), wide);
  EXPECT_EQ(allocations(), before + 8);
}

}  // namespace
}  // namespace ricochet
