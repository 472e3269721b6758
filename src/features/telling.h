#pragma once

#include <cstdint>
#include <functional>

#include "src/core/problem.h"
#include "src/features/draws.h"

namespace ricochet {

/// Whether what is drawn depends on how often the problem was called before, or on x alone, so that
/// to ask again is of no use.
enum class Drawn { by_call, by_point };

/// Changes what is told of one function: its values, and as many rows of slopes, or none where they
/// were not asked for. Must draw for the values before it draws for the slopes.
using Tell =
    std::function<void(Eigen::Ref<Vector> values, Eigen::Ref<Matrix> slopes, Draws& draws)>;

/// The problem with whatever it tells a solver changed. Objective and gradient are told together,
/// so are every constraint and its row of the Jacobian, and all residuals with their Jacobian. The
/// Hessian of the Lagrangian, whose multipliers change from call to call, is a function without
/// values; it stays symmetric. Each function has draws of its own, its values the same ones whether
/// its slopes are asked for or not.
Problem told_by(const Tell& tell, Drawn drawn, std::uint64_t key, const Problem& shown);

}  // namespace ricochet
