#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ricochet/solver.h"

namespace ricochet {

/// A line of the rule by which "auto" chooses: the first one that applies to what a problem
/// declares, and of which this build has a solver that takes the problem. Its evidence is the study
/// of src/studies/choice.
struct RuleLine {
  const char* name;                  ///< what it applies to, in a word or two
  const char* declared;              ///< the same in full
  const char* reason;                ///< why its solver
  std::vector<std::string> solvers;  ///< its solver, and what replaces it where the build lacks it
  bool (*applies)(const Evaluator& evaluator);
};

const std::vector<RuleLine>& rule_of_auto();

/// What "auto" chooses.
struct Choice {
  const RuleLine* line;
  std::string solver;
};

/// The choice among these solvers for the problem and budget of an evaluator; nothing if none of
/// the solvers that the rule names is there.
std::optional<Choice> choice_of(const Evaluator& evaluator, const std::vector<Solver>& solvers);

/// "auto": runs the solver that the rule chooses among these, from every start of a run.
Solver automatic(std::vector<Solver> solvers);

}  // namespace ricochet
