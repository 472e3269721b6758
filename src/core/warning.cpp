#include "src/core/warning.h"

#include <cstdio>
#include <mutex>
#include <set>

#include "src/core/one_line.h"

namespace ricochet {

void warn(const std::string& text) {
  static std::mutex mutex;
  static std::set<std::string> given;
  const std::lock_guard lock(mutex);
  if (given.insert(text).second) std::fputs(("warning: " + one_line(text) + "\n").c_str(), stderr);
}

}  // namespace ricochet
