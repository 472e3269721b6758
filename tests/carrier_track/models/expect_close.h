#pragma once

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::carrier_track {

/// Expects the value to be the other one but for this share of it.
inline void expect_close(double actual, double expected, double relative = 1e-12) {
  EXPECT_NEAR(actual, expected, relative * std::abs(expected));
}

}  // namespace ricochet::carrier_track
