#pragma once

#include <cstdint>
#include <functional>

#include "ricochet/problem.h"
#include "src/benchmark/experiment/perturbations/draws.h"

namespace ricochet {

/// Whether a draw depends on the number of calls so far, or on x only, so that repeated evaluations
/// give the same result.
enum class Drawn { by_call, by_point };

/// Changes one function as shown: its values, and as many rows of slopes, or none if slopes were
/// not requested. Must draw for the values before it draws for the slopes.
using Tell =
    std::function<void(Eigen::Ref<Vector> values, Eigen::Ref<Matrix> slopes, Draws& draws)>;

/// The problem with everything it shows a solver changed by `tell`. Objective and gradient are
/// changed together, so are every constraint and its row of the Jacobian, and all residuals with
/// their Jacobian. The Hessian of the Lagrangian, whose multipliers change from call to call, is a
/// function without values; it stays symmetric. Each function has its own draws; its values are the
/// same whether its slopes are requested or not.
Problem told_by(const Tell& tell, Drawn drawn, std::uint64_t key, const Problem& shown);

}  // namespace ricochet
