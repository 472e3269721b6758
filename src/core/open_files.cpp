#include "src/core/open_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "src/core/text_file.h"

namespace ricochet {
namespace {

/// Returns the limit with which so many descriptors are free: one more than the highest of them.
int limit_for(int number) {
  int limit = 0;
  for (int free = 0; free < number; ++limit) {
    if (fcntl(limit, F_GETFD) < 0) ++free;
  }
  return limit;
}

}  // namespace

void allow_further_open_files(int number) {
  const int needed = limit_for(number);
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  const rlim_t before = limit.rlim_cur;
  limit.rlim_cur = static_cast<rlim_t>(needed);
  if (before >= limit.rlim_cur) return;
  if (limit.rlim_cur <= limit.rlim_max && setrlimit(RLIMIT_NOFILE, &limit) == 0) return;
  throw OutputError(fmt::format("too many open files: the limit is {}; raise it with ulimit -n {}",
                                before, needed));
}

void lead_nowhere(int descriptor) {
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing < 0 || nothing == descriptor) return;
  dup2(nothing, descriptor);
  close(nothing);
}

}  // namespace ricochet
