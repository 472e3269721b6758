#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ricochet/solver.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/report/results.h"

namespace ricochet::studies::comparison {

/// Table "notes": version, note and solvers of each library of these solvers of which a reader must
/// know something; see library_note().
Table library_notes(const std::vector<Solver>& solvers);

/// The page of all solvers: table "solvers", by name, with the families and problems that each
/// takes, solved (number of these problems that it solved in at least one run, by the returned
/// point), the families of which it is first, and on whose Pareto front of speed and accuracy it
/// is; table "terminations", the termination reasons of all starts; and parts "solvers", one for
/// each. All is of the largest budgets and the solver's best formulation for a family, except for
/// the termination reasons, which are of all runs.
report::Results solvers_page(const Campaign& campaign, const std::vector<CellResult>& results,
                             const std::vector<EntrySet>& sets, const Table& speed_accuracy,
                             const Table& leaders);

/// How a solver of the suite is set, in words.
struct SolverSettings {
  std::string settings;
  std::string from;    ///< who chose them; may be empty
  std::string note;    ///< may be empty
  bool tuned = false;  ///< to problems of this suite
};

/// Nothing for a solver that solvers.toml does not have, such as a user's.
std::optional<SolverSettings> settings_of(const std::string& solver);

/// " (tuned to this suite)" of a solver whose settings were, if its name does not say so; else "".
std::string tuned_mark(const std::string& solver);

/// The solver that is the paper's algorithm.
inline constexpr const char* paper_solver = "fireworks";

/// Its kind in a word or two: "fireworks", "derivatives"; "other" for a solver that solvers.toml
/// does not have.
std::string kind_of(const std::string& solver);

/// What a reader must know of the library of this version, such as its age; mostly empty.
std::string library_note(const std::string& version);

}  // namespace ricochet::studies::comparison
