#include "src/cli/cores.h"

#include <tbb/global_control.h>

namespace ricochet::cli {

int cores() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace ricochet::cli
