#include "problems/classic/least_squares.h"

#include <fmt/format.h>

#include "problems/classic/least_squares_functions.h"

namespace ricochet::classic {

std::vector<Problem> least_squares_problems() {
  std::vector<Problem> problems = {
      linear_full_rank(9, 45, 1),
      linear_full_rank(9, 45, 10),
      linear_rank_1(7, 35, 1),
      linear_rank_1(7, 35, 10),
      linear_rank_1_with_zeros(7, 35, 1),
      linear_rank_1_with_zeros(7, 35, 10),
      rosenbrock_residuals(1),
      rosenbrock_residuals(10),
      helical_valley(1),
      helical_valley(10),
      powell_singular_residuals(1),
      powell_singular_residuals(10),
      freudenstein_roth(1),
      freudenstein_roth(10),
      bard(1),
      bard(10),
      kowalik_osborne(),
      meyer(),
      watson(6, 1),
      watson(6, 10),
      watson(9, 1),
      watson(9, 10),
      watson(12, 1),
      watson(12, 10),
      box_3d(),
      jennrich_sampson(),
      brown_dennis(1),
      brown_dennis(10),
      chebyquad(6),
      chebyquad(7),
      chebyquad(8),
      chebyquad(9),
      chebyquad(10),
      chebyquad(11),
      brown_almost_linear(10),
      osborne_1(),
      osborne_2(1),
      osborne_2(10),
      bdqrtic(8),
      bdqrtic(10),
      bdqrtic(11),
      bdqrtic(12),
      cube(5),
      cube(6),
      cube(8),
      mancino(5, 1),
      mancino(5, 10),
      mancino(8, 1),
      mancino(10, 1),
      mancino(12, 1),
      mancino(12, 10),
      heart_8(1),
      heart_8(10),
  };
  int number = 0;
  for (Problem& problem : problems) {
    problem.name = fmt::format("least-squares-{:02}-{}", ++number, problem.name);
  }
  return problems;
}

}  // namespace ricochet::classic
