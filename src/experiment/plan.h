#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/core/names.h"
#include "src/experiment/worker.h"

namespace ricochet {

/// A machine of the user, kept as text: a store needs no file of it.
struct PlanScene {
  std::string name;  ///< parts name it in machines.around, and its problems end in it
  std::string text;  ///< of the machine file

  bool operator==(const PlanScene&) const = default;
};

/// Machines around a given one, for every combination of the levels; without levels that machine
/// alone. The catalogue knows what may vary.
struct MachineGrid {
  std::string around;  ///< e.g. "C1", or a scene of the plan; empty: no grid
  std::map<std::string, std::vector<OptionValue>> levels;  ///< of what varies, by name

  std::string scene = {};  ///< text of the scene `around`; empty for a case. Campaigns fill it in

  bool operator==(const MachineGrid&) const = default;
};

/// A part of a plan: all combinations of its entries. Patterns are shell patterns.
struct PlanPart {
  std::string name = {};              ///< small letters, digits, hyphens; reports use it
  std::vector<std::string> problems;  ///< patterns of names
  MachineGrid machines;               ///< machines for the problems, in place of the suite's
  /// For every problem of one variable: number of machines drawn around its own, to replace it.
  int drawn_machines = 0;
  /// Instead of other instances: boxes with the best point at the lower end, in the middle and at
  /// the upper end; see campaign.h. Formulations without smoothing only.
  bool relocated_optimum = false;
  std::int64_t least_variables = 1;  ///< of problems
  std::int64_t most_variables = 1'000'000;
  std::optional<bool> constrained;   ///< only problems with, or without, constraints
  std::vector<std::string> solvers;  ///< patterns, or a user's solver
  std::vector<std::string> formulations = {"*"};
  std::vector<double> smoothings = {};  ///< of surrogates, besides the default one; > 0
  std::vector<std::string> perturbations = {"plain"};  ///< patterns; see all_perturbations()
  std::vector<std::string> gradient_prices = {"n"};    ///< "n", "measured" or evaluations
  std::vector<std::int64_t> budgets;                   ///< evaluations for each variable, ascending
  int instances = 15;                                  ///< 1, 2, ...
  int seeds = 1;                                       ///< number of runs on every instance

  /// Returns true if it asks for problems of so many variables and constraints.
  bool takes(std::int64_t variables, std::int64_t constraints) const;

  bool operator==(const PlanPart&) const = default;
};

/// A solver of the suite with other options and its own name.
struct VariedSolver {
  std::string name;
  std::string of;        ///< the solver
  GivenOptions options;  ///< to replace its defaults

  bool operator==(const VariedSolver&) const = default;
};

/// The content of a plan file.
struct Plan {
  std::string name;
  int first_instance = 1;  ///< parts begin there: other instances than those of another plan
  Limits limits;
  std::vector<VariedSolver> solvers = {};
  std::vector<PlanScene> scenes = {};
  std::vector<PlanPart> parts;
};

/// Returns the plan of a name that a plan has under `include`. Throws InputError if there is none.
using PlanByName = std::function<Plan(const std::string& name)>;

/// Reads a plan; the parts, solvers and scenes of the plans that it includes come after its own.
/// Throws InputError with origin, place, value and allowed range. Scenes must be given as text, and
/// without `included` no plan may be included: a plan in a store names no files.
Plan plan_from(const std::string& text, const std::string& origin, const PlanByName& included = {});

/// The same from a file. Scenes may be files, which are read at once.
Plan read_plan(const std::string& file, const PlanByName& included = {});

/// TOML text that reads back to the same plan.
std::string text_of(const Plan& plan);

}  // namespace ricochet
