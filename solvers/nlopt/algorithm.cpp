#include "solvers/nlopt/algorithm.h"

namespace ricochet {

bool NloptAlgorithm::is_original_direct() const {
  return id == NLOPT_GN_ORIG_DIRECT || id == NLOPT_GN_ORIG_DIRECT_L;
}

namespace {

using Constraints = Capabilities::Constraints;
using Order = Capabilities::Order;
using NoNumber = NloptAlgorithm::NoNumber;

constexpr Capabilities bounds_only = {};
constexpr Capabilities inequalities = {.constraints = Constraints::inequalities};
constexpr Capabilities all_constraints = {.constraints = Constraints::all};

constexpr Capabilities with_gradients(Capabilities capabilities) {
  capabilities.derivatives = Order::gradient;
  return capabilities;
}

/// The global algorithms. DIRECT is the original code where possible: NLopt's other version takes
/// no constraints.
std::vector<NloptAlgorithm> global_ones() {
  return {
      {.name = "direct",
       .id = NLOPT_GN_ORIG_DIRECT,
       .capabilities = inequalities,
       .no_number = NoNumber::is_infinite},
      {.name = "direct-l",
       .id = NLOPT_GN_ORIG_DIRECT_L,
       .capabilities = inequalities,
       .no_number = NoNumber::is_infinite},
      {.name = "crs2", .id = NLOPT_GN_CRS2_LM, .no_number = NoNumber::is_infinite, .draws = true},
      {.name = "isres",
       .id = NLOPT_GN_ISRES,
       .capabilities = all_constraints,
       .no_number = NoNumber::is_infinite,
       .draws = true},
      {.name = "esch", .id = NLOPT_GN_ESCH, .no_number = NoNumber::is_infinite, .draws = true},
      {.name = "ags",
       .id = NLOPT_GN_AGS,
       .capabilities = {.most_variables = 10, .constraints = Constraints::inequalities},
       .no_number = NoNumber::is_the_worst_so_far},
  };
}

/// A local algorithm, started from the points of a Sobol sequence one after the other.
NloptAlgorithm many_starts(const char* name, nlopt_algorithm local,
                           const Capabilities& capabilities) {
  return {.name = name,
          .id = NLOPT_G_MLSL_LDS,
          .local = local,
          .capabilities = capabilities,
          .no_number = NoNumber::is_the_worst_so_far};
}

/// Constraints for a local algorithm that takes none, or no equalities. For problems with
/// constraints only.
NloptAlgorithm augmented_lagrangian(const char* name, nlopt_algorithm local, Order derivatives) {
  return {
      .name = name,
      .id = NLOPT_AUGLAG,
      .local = local,
      .capabilities = {
          .constraints = Constraints::all, .needs_constraints = true, .derivatives = derivatives}};
}

std::vector<NloptAlgorithm> local_ones() {
  constexpr Capabilities smooth = with_gradients(bounds_only);
  return {
      {.name = "cobyla", .id = NLOPT_LN_COBYLA, .capabilities = all_constraints},
      // Steps smaller than a step of the function are not worth their evaluations.
      {.name = "cobyla-tuned",
       .id = NLOPT_LN_COBYLA,
       .capabilities = all_constraints,
       .tolerance = 1e-4},
      {.name = "bobyqa", .id = NLOPT_LN_BOBYQA},
      {.name = "nelder-mead", .id = NLOPT_LN_NELDERMEAD},
      {.name = "sbplx", .id = NLOPT_LN_SBPLX},
      {.name = "slsqp", .id = NLOPT_LD_SLSQP, .capabilities = with_gradients(all_constraints)},
      {.name = "mma", .id = NLOPT_LD_MMA, .capabilities = with_gradients(inequalities)},
      {.name = "ccsaq", .id = NLOPT_LD_CCSAQ, .capabilities = with_gradients(inequalities)},
      {.name = "lbfgs", .id = NLOPT_LD_LBFGS, .capabilities = smooth},
      {.name = "var2", .id = NLOPT_LD_VAR2, .capabilities = smooth},
      // Its preconditioned variants read uninitialised memory, so their runs may differ.
      {.name = "tnewton", .id = NLOPT_LD_TNEWTON_RESTART, .capabilities = smooth},
      augmented_lagrangian("auglag-bobyqa", NLOPT_LN_BOBYQA, Order::value),
      augmented_lagrangian("auglag-sbplx", NLOPT_LN_SBPLX, Order::value),
      augmented_lagrangian("auglag-lbfgs", NLOPT_LD_LBFGS, Order::gradient),
      augmented_lagrangian("auglag-mma", NLOPT_LD_MMA, Order::gradient),
  };
}

}  // namespace

std::vector<NloptAlgorithm> nlopt_algorithms() {
  std::vector<NloptAlgorithm> algorithms = global_ones();
  algorithms.push_back(many_starts("mlsl-bobyqa", NLOPT_LN_BOBYQA, bounds_only));
  algorithms.push_back(many_starts("mlsl-slsqp", NLOPT_LD_SLSQP, with_gradients(bounds_only)));
  algorithms.push_back(many_starts("mlsl-lbfgs", NLOPT_LD_LBFGS, with_gradients(bounds_only)));
  const std::vector<NloptAlgorithm> local = local_ones();
  algorithms.insert(algorithms.end(), local.begin(), local.end());
  for (NloptAlgorithm& algorithm : algorithms) {
    // It interpolates at n + 2 points or more, which is not possible in one dimension.
    const bool bobyqa = algorithm.id == NLOPT_LN_BOBYQA || algorithm.local == NLOPT_LN_BOBYQA;
    if (bobyqa) algorithm.capabilities.least_variables = 2;
  }
  return algorithms;
}

}  // namespace ricochet
