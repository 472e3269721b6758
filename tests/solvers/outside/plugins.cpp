// Libraries to load, most of them no solvers: PLUGIN says which this is.

#include <ricochet/ricochet.h>
#include <unistd.h>

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <vector>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

#define TEXT_OF(name) #name
#define NAME_OF(name) TEXT_OF(name)

namespace {

constexpr std::string_view library = NAME_OF(PLUGIN);

/// Changes the floating-point environment: how and when the environment variables CHANGE and WHEN
/// say.
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

[[gnu::constructor]] void on_load() {
  if (library == "aborts_on_load") std::abort();
  while (library == "hangs_on_load") pause();
  if (library == "changes_floating_point") change("loading");
}

/// Asks for points that no rounding changes.
const char* change_floating_point(ricochet_problem* problem, double* point) {
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

/// Asks once in its own thread, then by each function in others, and ends the process if one is
/// answered there.
const char* ask_from_threads(ricochet_problem* problem, double* point) {
  double objective = 0;
  problem->values(problem, point, &objective, nullptr);
  std::vector<std::thread> others;
  for (int k = 0; k < 4; ++k) {
    others.emplace_back([=, x = std::vector<double>(point, point + problem->dimension)] {
      double told = -7;
      std::vector<double> many(64, -7.0);
      for (int n = 0; n < 50; ++n) {
        const bool refused =
            problem->values(problem, x.data(), &told, nullptr) != 0 && told == -7 &&
            problem->derivatives(problem, x.data(), &told, nullptr, many.data(), nullptr) != 0 &&
            problem->residuals(problem, x.data(), many.data(), nullptr) != 0 &&
            problem->residual_count(problem, x.data()) == 0 && problem->remaining(problem) == 0 &&
            std::isnan(problem->uniform(problem)) && many[0] == -7;
        if (!refused) std::abort();
      }
    });
  }
  for (std::thread& other : others) other.join();
  return "done";
}

/// Asks for its start and for the upper end of the box, and hands over nothing.
const char* keep_the_start(ricochet_problem* problem, double* point) {
  problem->values(problem, point, nullptr, nullptr);
  problem->values(problem, problem->upper, nullptr, nullptr);
  return nullptr;
}

/// Goes from the problem's start to where its first constraint is 0, by Newton's method along the
/// gradient of that constraint.
const char* go_to_the_constraint(ricochet_problem* problem, double* point) {
  double objective = 0, constraint = 1, gradient[2], jacobian[2];
  for (int i = 0; i < 2; ++i) point[i] = problem->start[i];
  for (int step = 0; step < 50; ++step) {
    if (problem->derivatives(problem, point, &objective, &constraint, gradient, jacobian) != 0) {
      return "over";
    }
    const double square = jacobian[0] * jacobian[0] + jacobian[1] * jacobian[1];
    for (int i = 0; i < 2; ++i) point[i] -= (constraint + 1e-9) * jacobian[i] / square;
  }
  return "fifty steps";
}

/// Writes into all that it is shown of the problem, and then asks for a point far outside.
const char* widen_the_box(ricochet_problem* problem, double* point) {
  for (int i = 0; i < problem->dimension; ++i) {
    const_cast<double*>(problem->lower)[i] = -1e6;
    const_cast<double*>(problem->upper)[i] = 1e6;
    const_cast<double*>(problem->start)[i] = 1e6;
    point[i] = 1e6;
  }
  problem->dimension = 1;
  problem->values(problem, point, nullptr, nullptr);
  return "widened";
}

const char* solve(ricochet_problem* problem, double* point) {
  if (library == "changes_floating_point") return change_floating_point(problem, point);
  if (library == "asks_from_threads") return ask_from_threads(problem, point);
  if (library == "keeps_its_start") return keep_the_start(problem, point);
  if (library == "takes_constraints") return go_to_the_constraint(problem, point);
  if (library == "widens_its_box") return widen_the_box(problem, point);
  if (library != "throws") return "done";
  problem->values(problem, point, nullptr, nullptr);
  throw std::runtime_error("lost its way");
}

}  // namespace

// For without_a_solver this is compiled under another name.
extern "C" const ricochet_solver ricochet_plugin = {
    library == "of_another_interface" ? RICOCHET_ABI + 1 : RICOCHET_ABI,
    library == "bad_name"          ? reinterpret_cast<const char*>(std::uintptr_t{16})
    : library == "keeps_its_start" ? nullptr
                                   : NAME_OF(PLUGIN),
    library == "keeps_its_start" ? nullptr : "1",
    library == "throws"              ? 2
    : library == "takes_constraints" ? 1
                                     : 0,
    library == "takes_constraints",
    0,
    0,
    library == "without_solve" ? nullptr : solve};
