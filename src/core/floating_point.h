#pragma once

#include <cfenv>

namespace ricochet {

/// Makes this thread round to nearest, keep subnormal numbers and trap no exception. Code from
/// elsewhere may leave it otherwise: a library compiled with -Ofast changes it when it is loaded.
inline void reset_floating_point() {
  std::fesetenv(FE_DFL_ENV);
}

/// Does so while it lives, then restores what a caller from elsewhere had set.
class DefaultFloatingPoint {
 public:
  DefaultFloatingPoint() {
    std::fegetenv(&before_);
    reset_floating_point();
  }
  ~DefaultFloatingPoint() { std::fesetenv(&before_); }
  DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
  DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;

 private:
  std::fenv_t before_{};
};

}  // namespace ricochet
