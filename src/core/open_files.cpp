#include "src/core/open_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "src/core/text_file.h"

namespace ricochet {

void allow_open_files(int number) {
  const auto needed = static_cast<rlim_t>(number);
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= needed) return;
  const rlim_t before = limit.rlim_cur;
  limit.rlim_cur = needed;
  if (needed <= limit.rlim_max && setrlimit(RLIMIT_NOFILE, &limit) == 0) return;
  throw OutputError(fmt::format("too many open files: the limit is {}; raise it with ulimit -n {}",
                                before, number));
}

void lead_nowhere(int descriptor) {
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing < 0 || nothing == descriptor) return;
  dup2(nothing, descriptor);
  close(nothing);
}

}  // namespace ricochet
