#pragma once

#include <nlopt.h>

#include <optional>
#include <vector>

#include "src/core/problem.h"

namespace ricochet {

/// An algorithm of NLopt as ricochet runs it, and what NLopt 2.7.1 can do with it.
struct NloptAlgorithm {
  enum class Constraints {
    none,
    inequalities,
    all,
    always  ///< as `all`, but of no use without any
  };

  /// What becomes of a point where the problem has no number. Several local algorithms would report
  /// success there, or never return; AGS reads beyond its memory.
  enum class NoNumber {
    ends_the_search,
    is_infinite,
    is_the_worst_so_far,
  };

  const char* name;
  nlopt_algorithm id;
  std::optional<nlopt_algorithm> local = {};  ///< that it puts to work
  Constraints constraints = Constraints::none;
  NoNumber no_number = NoNumber::ends_the_search;
  bool draws = false;    ///< random numbers
  bool derives = false;  ///< needs derivatives
  Eigen::Index least_dimension = 1;
  Eigen::Index most_dimension = 1'000'000;
  double tolerance = 1e-8;     ///< step of the box below which a local search has converged
  double initial_step = 0.25;  ///< of the box; NLopt's own default, without its exceptions
  int population = 0;          ///< 0: NLopt's own
  int vectors = 10;            ///< that quasi-Newton methods keep; the default allocates 20 MB

  bool accepts(const Problem& problem) const;

  /// Whether it is the original code of DIRECT, which sets aside memory for all points at once.
  bool is_original_direct() const;
};

/// All that ricochet runs. Left out are StoGO, which ends the process where its local search
/// becomes unstable; NEWUOA, whose version with bounds may never return; PRAXIS, which knows no
/// bounds; augmented Lagrangians around COBYLA and SLSQP, which take all constraints themselves;
/// and near twins of what is there.
std::vector<NloptAlgorithm> nlopt_algorithms();

}  // namespace ricochet
