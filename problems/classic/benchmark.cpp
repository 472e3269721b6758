#include "problems/classic/benchmark.h"

namespace ricochet::classic {

Statement statement_of(const Benchmark& benchmark, Eigen::Index residuals, double scale) {
  const Vector start = scale * benchmark.start;
  const Vector& best = benchmark.best_point;
  const Vector beyond = 10 * start.cwiseAbs().cwiseMax(best.cwiseAbs()).cwiseMax(1.0);
  return {.name = fmt::format("{}-{}x{}{}", benchmark.name, start.size(), residuals,
                              scale == 1 ? "" : "-far"),
          .source = fmt::format("{}; half the sum of squares published by More and Wild (2009), "
                                "doi 10.1137/080724083",
                                benchmark.origin),
          .lower = benchmark.lower.size() > 0 ? benchmark.lower : start.cwiseMin(best) - beyond,
          .upper = benchmark.upper.size() > 0 ? benchmark.upper : start.cwiseMax(best) + beyond,
          .start = start,
          .best_known = benchmark.best_sum / 2,
          .best_point = best,
          .provenance = benchmark.provenance,
          .rotates = benchmark.rotates,
          .start_scales = benchmark.rotates ? std::vector<double>{1, 10, 100} : std::vector{1.0}};
}

std::string more_garbow_hillstrom(int number) {
  return fmt::format("More, Garbow and Hillstrom (1981), doi 10.1145/355934.355936, function {}",
                     number);
}

}  // namespace ricochet::classic
