#pragma once

#include <optional>

#include "problems/carrier_track/problems/machine.h"
#include "problems/searched_problem.h"

namespace ricochet::carrier_track::inline problems {

/// Largest relative difference of a constant of a drawn machine from the original.
inline constexpr double drawn_tolerance = 0.05;

/// A similar machine: every constant (see constants_of) times 0.95 to 1.05, independent and
/// uniform; restitution is at most 1. Quiet limit and threshold are kept; default_hash is cleared,
/// because best values do not carry over: see drawn_problem. Deterministic in id and number; "C1~3"
/// is number 3 around C1, and number 0 the machine itself. Throws std::invalid_argument for number
/// < 0.
Machine drawn_machine(Machine machine, int number);

/// The same problem of one variable for a machine drawn around its own, which is one of the cases.
/// Empty if it belongs to none of them or has several variables.
std::optional<SearchedProblem> drawn_problem(const Problem& problem, int number);

}  // namespace ricochet::carrier_track::inline problems
