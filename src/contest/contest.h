#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "src/campaign/worker.h"
#include "src/contest/outcomes.h"
#include "src/core/instance.h"
#include "src/core/question.h"
#include "src/core/solver.h"

/// Solvers put to questions and judged by what they can do. The form in which a question is shown
/// is a factor of its own: who takes part is a solver with a form.
namespace ricochet::contest {

struct ContestPlan {
  std::vector<Question> questions;  ///< whose best values are known
  std::vector<Solver> solvers;
  std::vector<double> widths;         ///< of surrogates, beside the usual one
  int instances = 15;                 ///< 1, 2, ... of every question
  std::vector<std::int64_t> budgets;  ///< evaluations for each variable, rising; runs of their own
  int run = 0;                        ///< number of the runs: another one is another seed
  Limits limits = {};                 ///< of every run
  /// Whether a form of a question is put to anybody.
  std::function<bool(const Question&, const Form&)> wants = [](const Question&, const Form&) {
    return true;
  };
  /// What instance 1, 2, ... of a problem is.
  std::function<Problem(const Problem&, int)> instance_of = instance;
};

/// All runs of a solver that is shown a question in one form, with one budget.
struct Standing {
  std::size_t question;  ///< its index in the plan
  std::string solver;
  Form form;
  std::size_t budget;  ///< its index in the plan
  Outcomes outcomes;   ///< of the instances, in their order
};

/// Runs every solver in every form that it accepts, in other processes, on all cores;
/// standings by question, then solver, form and budget. The same every time, but for the times.
/// Throws std::invalid_argument for a question whose best value is not known.
std::vector<Standing> hold(const ContestPlan& plan);

}  // namespace ricochet::contest
