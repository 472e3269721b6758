#pragma once

#include <string>

#include "ricochet/problem.h"

namespace ricochet {

/// 16 hexadecimal digits that depend on every bit behind the scores of a problem's runs: box,
/// start, tolerance, weight, best value, formulations, the true values at start and best point, and
/// box, start and best point of its first instance. Equal hashes: runs can be compared.
std::string problem_hash(const Problem& problem);

}  // namespace ricochet
