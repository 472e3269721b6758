#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/own/own_problem.h"
#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "src/app/command_line.h"
#include "src/report/json.h"

namespace ricochet::cli {

/// Which problem a command is about.
struct ProblemChoice {
  std::string name;  ///< of a problem of the suite, or a problem file
  std::string scene_file;
  std::vector<std::string> settings;
  bool allow_programs = false;  ///< that the problem file names
};

/// Adds the problem, --scene, --set and --allow-programs.
void add_problem_choice(CLI::App* command, ProblemChoice& choice);

struct ChosenProblem {
  Problem problem;
  std::optional<own::OwnProblem> own;  ///< of a problem file
};

/// `run` names who asks, for the evaluations of a noisy problem. Throws InputError if there is no
/// such problem, or if it starts a program and that is not allowed.
ChosenProblem choose_problem(const ProblemChoice& choice, const std::string& run);

/// Throw InputError unless the option of this name, of a run, is within its range.
void check_budget(std::int64_t budget);
void check_seed(int seed);

/// The formulation of this name, or without one the first that the solver accepts. Throws
/// InputError if there is none.
Formulation accepted_formulation(const Problem& problem, const Solver& solver,
                                 const std::string& wanted = "");

/// The best point of a run, in a user's own words.
struct OwnAnswer {
  struct Coordinate {
    std::string name, unit;
    double value;
    const char* bound;  ///< "lower", "upper" or ""
  };
  struct Constraint {
    std::string name;
    double value;
    bool holds, active;
  };
  double objective = 0;  ///< as the goal has it; of a noisy problem, the run's best
  std::vector<Coordinate> point;
  std::vector<Constraint> constraints;
  /// Of a noisy problem, of the evaluations of the point, which were repeated.
  std::optional<double> mean, standard_error;
  std::int64_t repetitions = 0;
};

/// The answer at a point in the solver's coordinates, where the run has found this objective, as
/// the goal has it; of a noisy problem the point is evaluated again until the standard error of the
/// mean is below the file's tolerance, `most` times at most.
OwnAnswer answer_at(const own::OwnProblem& own, const Vector& seen, double objective,
                    std::int64_t most);

/// The lines that say it, and those on the evaluations, of which there are so many.
std::string in_words(const own::OwnProblem& own, const OwnAnswer& answer);
std::string evaluations_in_words(const own::OwnProblem& own, const own::EvaluationCounts& counts);

/// The same as JSON.
report::Json json_of(const own::OwnProblem& own, const own::EvaluationCounts& counts,
                     const std::optional<OwnAnswer>& answer);

}  // namespace ricochet::cli
