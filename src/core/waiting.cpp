#include "src/core/waiting.h"

#include <cstdio>
#include <utility>

namespace ricochet {
namespace {

std::function<void(const std::string&)>& listener() {
  static std::function<void(const std::string&)> listener;
  return listener;
}

}  // namespace

void tell_waiting(const std::string& text) {
  if (!text.empty()) std::fputs((text + "\n").c_str(), stderr);
  if (listener()) listener()(text);
}

void on_waiting(std::function<void(const std::string&)> told) {
  listener() = std::move(told);
}

}  // namespace ricochet
