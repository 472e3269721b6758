// WebAssembly has no exceptions here: what is thrown ends the instance, and its message stays as
// the text of the border, for the caller.
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <typeinfo>

#include "ricochet/error.h"

namespace ricochet::live {
namespace {

std::string message;

bool has_a_message(const std::type_info& type) {
  for (const std::type_info* known :
       {&typeid(InputError), &typeid(std::runtime_error), &typeid(std::logic_error),
        &typeid(std::invalid_argument), &typeid(std::domain_error), &typeid(std::length_error),
        &typeid(std::out_of_range), &typeid(std::bad_alloc)}) {
    if (type == *known) return true;
  }
  return false;
}

}  // namespace

/// What has ended the instance.
__attribute__((export_name("failure"))) const char* failure() {
  return message.data();
}
__attribute__((export_name("failure_size"))) int failure_size() {
  return static_cast<int>(message.size());
}

}  // namespace ricochet::live

// What the compiler makes of a throw expression; see the Itanium C++ ABI for exceptions. The real
// ones, and their messages on a terminal, are not linked then.
extern "C" {

void* __cxa_allocate_exception(std::size_t size) noexcept {
  return std::malloc(size);
}

void __cxa_throw(void* thrown, std::type_info* type, void (* /*destroy*/)(void*)) {
  using namespace ricochet::live;
  message = has_a_message(*type) ? static_cast<std::exception*>(thrown)->what() : type->name();
  __builtin_trap();
}

void abort_message(const char* /*format*/, ...) {
  __builtin_trap();
}

void abort() {
  __builtin_trap();
}
}
