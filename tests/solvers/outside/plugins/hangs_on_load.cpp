#include <ricochet/ricochet.h>
#include <unistd.h>

namespace {

[[gnu::constructor]] void on_load() {
  for (;;) pause();
}

const char* solve(ricochet_problem*, double*) {
  return "done";
}

}  // namespace

extern "C" const ricochet_solver ricochet_plugin = {RICOCHET_ABI, "hangs", "1.0", 0, 0, 0, 0,
                                                    solve};
