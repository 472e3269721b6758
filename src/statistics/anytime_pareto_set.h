#pragma once

#include <cstddef>
#include <vector>

namespace ricochet {

/// The solvers, rising, for which there is no rival that is better at every checkpoint: whoever
/// leads or draws level once, against each of the others, stays. A row for each solver, an entry
/// for each checkpoint, the same for all; less is better (ranks, regrets), infinite allowed. Throws
/// std::invalid_argument for rows of different length, no checkpoints, or a value that is no
/// number.
std::vector<std::size_t> anytime_pareto_set(const std::vector<std::vector<double>>& values);

}  // namespace ricochet
