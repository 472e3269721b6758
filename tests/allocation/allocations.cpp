#include "tests/allocation/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> count{0};

void* allocate(std::size_t size) noexcept {
  ++count;
  return std::malloc(size > 0 ? size : 1);
}

void* allocate(std::size_t size, std::align_val_t alignment) noexcept {
  ++count;
  const auto step = static_cast<std::size_t>(alignment);
  const std::size_t steps = size > 0 ? (size + step - 1) / step : 1;
  return std::aligned_alloc(step, steps * step);
}

void* checked(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

std::int64_t ricochet::allocations() {
  return count;
}

// NOTE: all formulations are replaced, not only those that the others call by default: a
// sanitizer's own defaults call none of them.
#define DELETE(brackets, ...)                                                       \
  void operator delete brackets(void* memory __VA_OPT__(, ) __VA_ARGS__) noexcept { \
    std::free(memory);                                                              \
  }
#define NEW_AND_DELETE(brackets)                                                  \
  void* operator new brackets(std::size_t size) {                                 \
    return checked(allocate(size));                                               \
  }                                                                               \
  void* operator new brackets(std::size_t size, std::align_val_t alignment) {     \
    return checked(allocate(size, alignment));                                    \
  }                                                                               \
  void* operator new brackets(std::size_t size, const std::nothrow_t&) noexcept { \
    return allocate(size);                                                        \
  }                                                                               \
  void* operator new brackets(std::size_t size, std::align_val_t alignment,       \
                              const std::nothrow_t&) noexcept {                   \
    return allocate(size, alignment);                                             \
  }                                                                               \
  DELETE(brackets)                                                                \
  DELETE(brackets, std::size_t)                                                   \
  DELETE(brackets, std::align_val_t)                                              \
  DELETE(brackets, std::size_t, std::align_val_t)                                 \
  DELETE(brackets, const std::nothrow_t&)                                         \
  DELETE(brackets, std::align_val_t, const std::nothrow_t&)

NEW_AND_DELETE()
NEW_AND_DELETE([])
