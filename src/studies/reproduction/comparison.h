#pragma once

#include <string>
#include <vector>

#include "src/core/run.h"
#include "src/core/solver.h"
#include "src/statistics/expected_running_time.h"

namespace ricochet::studies::reproduction {

/// Median of the best true value reached over all runs, with its 95 % bootstrap interval, at a
/// common grid of prices. Positions before every run has a truly feasible point are left out.
struct Progression {
  std::string solver;
  std::vector<double> price;
  std::vector<double> median, lower, upper;
};

/// What a contest asks for.
enum class Goal { count, top_speed };

/// A question as some solvers can take it.
struct Form {
  std::string label;  ///< what a solver is shown
  Problem problem;
};

/// One question, put to all solvers: each gets the first form that it accepts, and all are judged
/// by the truth, which the forms share.
struct Contest {
  std::string case_id;
  Goal goal;
  std::vector<Form> forms;
  double tolerance = 0;  ///< regret that still counts as solved
};

/// How a solver did in one contest; one entry a run in every list.
struct Standing {
  std::string solver;
  std::string form;                          ///< what it was shown
  int failed = 0;                            ///< runs that ended in an exception
  std::vector<double> regrets;               ///< infinite where a run found nothing feasible
  std::vector<Effort> evaluations, seconds;  ///< until solved, or in all
};

struct ContestResult {
  std::string case_id;
  Goal goal;
  double best_known = 0;
  std::vector<Standing> standings;
  std::vector<Progression> by_evaluations;
  std::vector<Progression> by_seconds;
};

struct ComparisonPlan {
  int instances = 15;
  Budget budget;
};

/// Runs every solver on instances 1..n of every contest, in parallel, and sums up.
std::vector<ContestResult> compare(const std::vector<Contest>& contests,
                                   const std::vector<Solver>& solvers, const ComparisonPlan& plan);

}  // namespace ricochet::studies::reproduction
