#pragma once

#include <optional>
#include <string>

#include "ricochet/solver.h"

namespace ricochet::studies::comparison {

/// How a solver of the suite is set, in words.
struct SolverSettings {
  std::string settings;
  std::string from;  ///< who chose them; may be empty
  std::string note;  ///< may be empty
};

/// Nothing for a solver that reports/templates/solvers.toml does not have, such as a user's.
std::optional<SolverSettings> settings_of(const std::string& solver);

/// The solver that is the paper's algorithm.
inline constexpr const char* paper_solver = "fireworks";

/// Its kind in a word or two: "fireworks", "derivatives"; "other" for a solver that solvers.toml
/// does not have.
std::string kind_of(const std::string& solver);

/// What a reader must know of the library of this version, such as its age; mostly empty.
std::string library_note(const std::string& version);

}  // namespace ricochet::studies::comparison
