#include "problems/classic/hock_schittkowski_statement.h"

#include <fmt/format.h>

namespace ricochet::classic {

Statement hock_schittkowski(int number, const std::string& author, Vector lower, Vector upper,
                            Vector start, Optimum optimum) {
  return {.name = fmt::format("hs-{}", number),
          .source = fmt::format("Hock and Schittkowski (1981), doi 10.1007/978-3-642-48320-2, "
                                "problem {}{}{}",
                                number, author.empty() ? "" : ", of ", author),
          .lower = std::move(lower),
          .upper = std::move(upper),
          .start = std::move(start),
          .best_known = optimum.value,
          .best_point = std::move(optimum.point),
          .provenance = std::move(optimum.provenance),
          .rotates = optimum.everywhere,
          .start_scales = {1}};
}

Problem with_equations(Problem problem, Eigen::Index equations) {
  problem.equalities = equations;
  return problem;
}

}  // namespace ricochet::classic
