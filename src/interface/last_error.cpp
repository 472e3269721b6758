#include "src/interface/last_error.h"

#include <string>

#include "src/core/one_line.h"

namespace ricochet::interface {
namespace {

thread_local std::string kept;
thread_local const char* shown = "";

}  // namespace

const char* last_error() noexcept {
  return shown;
}

void keep_error(const std::exception_ptr& failure) noexcept {
  if (!failure) return;
  try {
    try {
      std::rethrow_exception(failure);
    } catch (const std::exception& error) {
      kept = one_line(error.what());
    } catch (...) {
      kept = "an exception that is not a std::exception";
    }
    shown = kept.c_str();
  } catch (...) {  // the message could not be stored
    shown = "there is not enough memory";
  }
}

}  // namespace ricochet::interface
