#include <ricochet/ricochet.h>

#include <cstdint>

namespace {

const char* solve(ricochet_problem*, double*) {
  return "done";
}

}  // namespace

extern "C" const ricochet_solver ricochet_plugin = {
    RICOCHET_ABI, reinterpret_cast<const char*>(std::uintptr_t{16}), "1.0", 0, 0, 0, 0, solve};
