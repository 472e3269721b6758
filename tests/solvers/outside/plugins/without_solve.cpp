#include <ricochet/ricochet.h>

const ricochet_solver ricochet_plugin = {RICOCHET_ABI, "idle", "1", 0, 0, 0, 0, nullptr};
