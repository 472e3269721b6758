#include <ricochet/ricochet.h>

#include <cfenv>
#include <cstdlib>
#include <cstring>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

/// Changes the floating-point environment: how and when the environment variables CHANGE and WHEN
/// say.
namespace {

void change(const char* when) {
  const char* now = std::getenv("WHEN");
  const char* how = std::getenv("CHANGE");
  if (now == nullptr || how == nullptr || std::strcmp(now, when) != 0) return;
  if (std::strcmp(how, "up") == 0) std::fesetround(FE_UPWARD);
  if (std::strcmp(how, "down") == 0) std::fesetround(FE_DOWNWARD);
  if (std::strcmp(how, "to zero") == 0) std::fesetround(FE_TOWARDZERO);
#ifdef __SSE__
  if (std::strcmp(how, "flush") == 0) _mm_setcsr(_mm_getcsr() | 0x8040U);  // as -Ofast does
#endif
  if (std::strcmp(how, "trap") == 0) feenableexcept(FE_INEXACT | FE_UNDERFLOW | FE_DIVBYZERO);
}

struct Loaded {
  Loaded() { change("loading"); }
} const loaded;

/// Asks for points that no rounding changes.
const char* solve(ricochet_problem* problem, double* point) {
  change("solving");
  double scale = 1;
  double objective = 0;
  for (int k = 0; k < 20; ++k, scale /= 2) {
    for (int i = 0; i < problem->dimension; ++i) point[i] = scale;
    if (problem->values(problem, point, &objective, nullptr) != 0) break;
    change("between evaluations");
  }
  return "done";
}

}  // namespace

const ricochet_solver ricochet_plugin = {RICOCHET_ABI, "changes", "1", 0, 0, 0, 0, solve};
