#pragma once

#include <map>
#include <string>

#include "ricochet/problem.h"
#include "src/core/instance.h"

namespace ricochet::carrier_track::inline problems {

/// The best true objective known of a problem.
struct BestKnown {
  double value;            ///< true objective; infinite if no feasible point was found
  Vector point;            ///< where it is attained; empty if none was found
  std::string provenance;  ///< how it was found
};

/// Best known values of the cases' problems, by problem name.
struct BestValues {
  std::string machine;  ///< default_machine_hash() of the machine for which they hold
  std::map<std::string, BestKnown> of;
};

/// Throws InputError, with origin and name, for invalid text.
BestValues parse_best_values(const std::string& text, const std::string& origin);

/// Returns text that parses back to the same values, bit for bit.
std::string write_best_values(const BestValues& values);

/// The values in best_known.toml, which `ricochet best-values` regenerates.
const BestValues& best_values();

/// Sets the problem's best known value, if best_values() hold for the default machine of this hash.
void know_best(Problem& problem, const std::string& machine);

/// The problem and all its smoothed formulations, with this best known value.
Problem knowing(Problem problem, const BestKnown& best);

// The best value of a problem of one variable, by exhaustive scan.

/// The best true objective of a problem of one variable: the best (on a tie the lowest) multiple of
/// the step in its box, improved by bisection, to 1e-7, if a better point lies within a step, and
/// repeated from any better point up to ten steps away. Infinite, without a point, if no feasible
/// point is found.
BestKnown scan_for_best(const Problem& problem, double step);

/// The "best_point" found by a scan with the problem's scan_step; empty if no point is feasible.
/// Throws std::invalid_argument for a problem of several variables.
Findings scanned_best(const Problem& problem);

/// The problem with these findings' best point and its value.
Problem with_scanned_best(Problem problem, const Findings& found);

}  // namespace ricochet::carrier_track::inline problems
