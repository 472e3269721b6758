#include <ricochet/ricochet.h>

#include <cstdlib>

namespace {

[[gnu::constructor]] void on_load() {
  std::abort();
}

const char* solve(ricochet_problem*, double*) {
  return "done";
}

}  // namespace

extern "C" const ricochet_solver ricochet_plugin = {RICOCHET_ABI, "aborts", "1.0", 0, 0, 0, 0,
                                                    solve};
