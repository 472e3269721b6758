#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/campaign/worker.h"
#include "src/core/option_value.h"

namespace ricochet {

/// Machines around one of the paper's, for every combination of what is named. A list that is empty
/// leaves the machine's own.
struct MachineGrid {
  std::string around;  ///< id of a case, e.g. "C1"; empty: there is no grid
  std::vector<double> restitution, friction, disturbance;
  std::vector<std::string> fidelity;  ///< levels of the simulation, by name

  bool operator==(const MachineGrid&) const = default;
};

/// A part of a plan: everything that is named, crossed with everything else. Patterns are those of
/// a shell.
struct PlanPart {
  std::string name = {};               ///< small letters, digits, hyphens; reports use it
  std::vector<std::string> questions;  ///< patterns of names
  MachineGrid machines;                ///< that they are asked of, in place of the suite's
  std::int64_t least_variables = 1;    ///< of questions
  std::int64_t most_variables = 1'000'000;
  std::optional<bool> constrained;   ///< only questions that are, or that are not
  std::vector<std::string> solvers;  ///< patterns, or a solver of the user's own
  std::vector<std::string> forms = {"*"};
  std::vector<double> widths = {};                   ///< of surrogates, beside the usual one; > 0
  std::vector<std::string> features = {"plain"};     ///< patterns; see all_features
  std::vector<std::string> gradient_prices = {"n"};  ///< "n", "measured" or evaluations
  std::vector<std::int64_t> budgets;                 ///< evaluations for each variable, rising
  int instances = 15;                                ///< 1, 2, ...
  int seeds = 1;                                     ///< runs on every instance

  bool operator==(const PlanPart&) const = default;
};

/// A solver of the suite with other options, under a name of its own.
struct VariedSolver {
  std::string name;
  std::string of;        ///< the solver
  GivenOptions options;  ///< in place of its own

  bool operator==(const VariedSolver&) const = default;
};

/// What a campaign runs.
struct Plan {
  std::string name;
  Limits limits;
  std::vector<VariedSolver> solvers = {};
  std::vector<PlanPart> parts;
};

/// Reads a plan. Throws InputError with origin, place, value and allowed range.
Plan plan_from(const std::string& text, const std::string& origin);

/// The same from a file.
Plan read_plan(const std::string& file);

/// TOML that reads back to the same plan.
std::string text_of(const Plan& plan);

}  // namespace ricochet
