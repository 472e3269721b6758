#include <gtest/gtest.h>

#include "src/core/instance.h"

namespace ricochet {
namespace {

// Values of the test vectors in RFC 9923.
TEST(FnvHash, HasThePublishedValues) {
  FnvHash hash;
  EXPECT_EQ(hash.value(), 0xcbf29ce484222325U);
  hash.add("foo");
  hash.add("bar");
  EXPECT_EQ(hash.value(), 0x85944171f73967e8U);
}

}  // namespace
}  // namespace ricochet
