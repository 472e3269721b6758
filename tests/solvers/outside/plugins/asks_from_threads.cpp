#include <ricochet/ricochet.h>

#include <cmath>
#include <cstdlib>
#include <thread>
#include <vector>

/// Asks once in its own thread, then by each function in others, and ends the process if one is
/// answered there.
namespace {

const char* solve(ricochet_problem* problem, double* point) {
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

}  // namespace

const ricochet_solver ricochet_plugin = {RICOCHET_ABI, "threads", "1", 0, 0, 0, 0, solve};
