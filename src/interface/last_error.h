#pragma once

#include <exception>
#include <utility>

namespace ricochet::interface {

/// What went wrong last in this thread, in one line; "" where nothing did. Stays valid until the
/// next error in this thread.
const char* last_error() noexcept;

/// Keeps what the exception says as the last error; does nothing where it is null.
void keep_error(const std::exception_ptr& failure) noexcept;

/// Does the work, and keeps what it throws. Returns whether it threw nothing.
template <class Work>
bool succeeds(Work&& work) noexcept {
  try {
    std::forward<Work>(work)();
    return true;
  } catch (...) {
    keep_error(std::current_exception());
    return false;
  }
}

}  // namespace ricochet::interface
