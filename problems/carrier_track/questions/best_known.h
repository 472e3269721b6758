#pragma once

#include <map>
#include <string>

#include "src/core/problem.h"

namespace ricochet::carrier_track::inline questions {

/// The best truth found of a problem so far.
struct BestKnown {
  double value;            ///< true objective; infinite where no feasible point was found
  Vector point;            ///< where it is attained; empty where none was found
  std::string provenance;  ///< how it was found
};

/// Best values of the cases' problems in one reading, by the problems' names.
struct BestValues {
  std::string reading;
  std::map<std::string, BestKnown> of;
};

/// Throws InputError, with origin and name, for a text that holds none.
BestValues parse_best_values(const std::string& text, const std::string& origin);

/// The text that is read back to the same values, bit for bit.
std::string write_best_values(const BestValues& values);

/// best_known.toml, which `ricochet best-values` regenerates.
const BestValues& best_values();

/// Tells the problem, of a case in this reading, its best value, where best_values() are of that
/// reading. An empty name is no reading.
void know_best(Problem& problem, const std::string& reading);

/// The problem, and whatever it is smoothed to, with this best value.
Problem knowing(Problem problem, const BestKnown& best);

}  // namespace ricochet::carrier_track::inline questions
