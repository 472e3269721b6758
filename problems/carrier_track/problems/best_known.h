#pragma once

#include <map>
#include <string>

#include "ricochet/problem.h"

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

}  // namespace ricochet::carrier_track::inline problems
