#pragma once

#include <exception>
#include <string>
#include <utility>

#include "src/core/floating_point.h"

namespace ricochet::interface {

/// The last error in this thread, in one line; "" if there was none. Valid until the next error in
/// this thread.
const char* last_error() noexcept;

/// Stores the exception's message as the last error; does nothing for null.
void keep_error(const std::exception_ptr& failure) noexcept;

/// Does the work, whatever the caller's rounding is, and stores its exception, if any. Returns true
/// if nothing was thrown.
template <class Work>
bool succeeds(Work&& work) noexcept {
  const DefaultFloatingPoint ours;
  try {
    std::forward<Work>(work)();
    return true;
  } catch (...) {
    keep_error(std::current_exception());
    return false;
  }
}

/// The text of a machine file, "-" for standard input. Throws InputError if it cannot be read.
std::string scene_text(const std::string& file);

}  // namespace ricochet::interface

/// Marks the definition of a function that ricochet.h declares.
#define RICOCHET_EXPORTED extern "C" __attribute__((visibility("default")))
