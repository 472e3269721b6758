#include "solvers/outside/claims.h"

#include <fmt/format.h>

#include <array>

#include "ricochet/error.h"
#include "src/core/name.h"
#include "src/core/one_line.h"

namespace ricochet::outside {
Solver solver_as_claimed(const Claims& claims, const std::string& source) {
  const std::string& name = claims.name;
  if (!is_name(name)) {
    throw InputError(fmt::format("{}: name \"{}\"; allowed are {}", source, name, names_in_words));
  }
  if (claims.takes_constraints < 0 || claims.takes_constraints > 2) {
    throw InputError(fmt::format("{}: takes_constraints {}; allowed are 0, 1 and 2", source,
                                 claims.takes_constraints));
  }
  Solver solver;
  solver.name = name;
  solver.version = one_line(claims.version);
  solver.stochastic = claims.stochastic;
  using Constraints = Capabilities::Constraints;
  solver.capabilities.constraints =
      std::array{Constraints::none, Constraints::inequalities,
                 Constraints::all}[static_cast<std::size_t>(claims.takes_constraints)];
  if (claims.needs_derivatives) solver.capabilities.derivatives = Capabilities::Order::gradient;
  solver.capabilities.needs_residuals = claims.needs_residuals;
  return solver;
}

}  // namespace ricochet::outside
