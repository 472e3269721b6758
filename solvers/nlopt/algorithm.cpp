#include "solvers/nlopt/algorithm.h"

#include "solvers/unit_box.h"

namespace ricochet {

bool NloptAlgorithm::accepts(const Problem& problem) const {
  const Eigen::Index n = problem.dimension();
  if (!has_room(problem) || n < least_dimension || n > most_dimension) return false;
  if (derives && !problem.differentiate) return false;
  switch (constraints) {
    case Constraints::none:
      return problem.constraints == 0;
    case Constraints::inequalities:
      return problem.equalities == 0;
    case Constraints::all:
      return true;
    case Constraints::always:
      return problem.constraints > 0;
  }
  return false;
}

bool NloptAlgorithm::is_original_direct() const {
  return id == NLOPT_GN_ORIG_DIRECT || id == NLOPT_GN_ORIG_DIRECT_L;
}

namespace {

using Constraints = NloptAlgorithm::Constraints;
using NoNumber = NloptAlgorithm::NoNumber;

/// Those that look everywhere. DIRECT is the original code where it can be: the other one in NLopt
/// takes no constraints.
std::vector<NloptAlgorithm> global_ones() {
  return {
      {.name = "direct",
       .id = NLOPT_GN_ORIG_DIRECT,
       .constraints = Constraints::inequalities,
       .no_number = NoNumber::is_infinite},
      {.name = "direct-l",
       .id = NLOPT_GN_ORIG_DIRECT_L,
       .constraints = Constraints::inequalities,
       .no_number = NoNumber::is_infinite},
      {.name = "crs2", .id = NLOPT_GN_CRS2_LM, .no_number = NoNumber::is_infinite, .draws = true},
      {.name = "isres",
       .id = NLOPT_GN_ISRES,
       .constraints = Constraints::all,
       .no_number = NoNumber::is_infinite,
       .draws = true},
      {.name = "esch", .id = NLOPT_GN_ESCH, .no_number = NoNumber::is_infinite, .draws = true},
      {.name = "ags",
       .id = NLOPT_GN_AGS,
       .constraints = Constraints::inequalities,
       .no_number = NoNumber::is_the_worst_so_far,
       .most_dimension = 10},
  };
}

/// A local algorithm put to work from one point of a Sobol sequence after the other.
NloptAlgorithm many_starts(const char* name, nlopt_algorithm local, bool derives) {
  return {.name = name,
          .id = NLOPT_G_MLSL_LDS,
          .local = local,
          .no_number = NoNumber::is_the_worst_so_far,
          .derives = derives};
}

/// Constraints for a local algorithm that takes none, or no equations.
NloptAlgorithm augmented_lagrangian(const char* name, nlopt_algorithm local, bool derives) {
  return {.name = name,
          .id = NLOPT_AUGLAG,
          .local = local,
          .constraints = Constraints::always,
          .derives = derives};
}

std::vector<NloptAlgorithm> local_ones() {
  return {
      {.name = "cobyla", .id = NLOPT_LN_COBYLA, .constraints = Constraints::all},
      // What a step smaller than a step of the function can find is not worth its evaluations.
      {.name = "cobyla-tuned",
       .id = NLOPT_LN_COBYLA,
       .constraints = Constraints::all,
       .tolerance = 1e-4},
      {.name = "bobyqa", .id = NLOPT_LN_BOBYQA},
      {.name = "nelder-mead", .id = NLOPT_LN_NELDERMEAD},
      {.name = "sbplx", .id = NLOPT_LN_SBPLX},
      {.name = "slsqp", .id = NLOPT_LD_SLSQP, .constraints = Constraints::all, .derives = true},
      {.name = "mma",
       .id = NLOPT_LD_MMA,
       .constraints = Constraints::inequalities,
       .derives = true},
      {.name = "ccsaq",
       .id = NLOPT_LD_CCSAQ,
       .constraints = Constraints::inequalities,
       .derives = true},
      {.name = "lbfgs", .id = NLOPT_LD_LBFGS, .derives = true},
      {.name = "var2", .id = NLOPT_LD_VAR2, .derives = true},
      // Its preconditioned forms read memory that they have not set: their runs may differ.
      {.name = "tnewton", .id = NLOPT_LD_TNEWTON_RESTART, .derives = true},
      augmented_lagrangian("auglag-bobyqa", NLOPT_LN_BOBYQA, false),
      augmented_lagrangian("auglag-sbplx", NLOPT_LN_SBPLX, false),
      augmented_lagrangian("auglag-lbfgs", NLOPT_LD_LBFGS, true),
      augmented_lagrangian("auglag-mma", NLOPT_LD_MMA, true),
  };
}

}  // namespace

std::vector<NloptAlgorithm> nlopt_algorithms() {
  std::vector<NloptAlgorithm> algorithms = global_ones();
  algorithms.push_back(many_starts("mlsl-bobyqa", NLOPT_LN_BOBYQA, false));
  algorithms.push_back(many_starts("mlsl-slsqp", NLOPT_LD_SLSQP, true));
  algorithms.push_back(many_starts("mlsl-lbfgs", NLOPT_LD_LBFGS, true));
  const std::vector<NloptAlgorithm> local = local_ones();
  algorithms.insert(algorithms.end(), local.begin(), local.end());
  for (NloptAlgorithm& algorithm : algorithms) {
    // It interpolates at n + 2 points at least, more than it can place in one dimension.
    const bool bobyqa = algorithm.id == NLOPT_LN_BOBYQA || algorithm.local == NLOPT_LN_BOBYQA;
    if (bobyqa) algorithm.least_dimension = 2;
  }
  return algorithms;
}

}  // namespace ricochet
