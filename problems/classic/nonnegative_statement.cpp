#include "problems/classic/nonnegative_statement.h"

#include <fmt/format.h>

namespace ricochet::classic {

Statement nonnegative(const char* name, const char* source, double lower, double upper,
                      Vector best) {
  const Eigen::Index n = best.size();
  return {.name = fmt::format("classic-{}-{}", name, n),
          .source = source,
          .lower = Vector::Constant(n, lower),
          .upper = Vector::Constant(n, upper),
          .start = Vector::Constant(n, lower + 0.8 * (upper - lower)),
          .best_known = 0,
          .best_point = std::move(best),
          .provenance = "closed form: no term is negative, and all are 0 there",
          .rotates = true};
}

}  // namespace ricochet::classic
