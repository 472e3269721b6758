#pragma once

#include <string>
#include <vector>

#include "src/campaign/progress.h"
#include "src/core/run.h"
#include "src/core/solver.h"
#include "src/statistics/bootstrap.h"

namespace ricochet::reproduction {

/// Median of the best true value reached over all runs, with its 95 % bootstrap interval, at a
/// common grid of prices. Positions before every run has a truly feasible point are left out.
struct Progression {
  std::string solver;
  std::vector<double> price;
  std::vector<double> median, lower, upper;
};

/// One question, put to all solvers that can take it: those without derivatives get the true count,
/// those with derivatives the surrogate; all are judged by the true count.
struct Contest {
  std::string name;
  Problem exact;         ///< without derivatives
  Problem smooth;        ///< with derivatives
  double tolerance = 0;  ///< regret that still counts as solved
};

/// How a solver did over all its runs in one contest.
struct Standing {
  std::string solver;
  bool smooth = false;  ///< it was shown the surrogate
  int runs = 0;
  int solved = 0;  ///< runs that reached the best known value within the contest's tolerance
  int failed = 0;  ///< runs that ended in an exception
  double median_regret = 0;  ///< infinite where half the runs found nothing feasible
  std::optional<double> evaluations_to_solve;  ///< expected running time
  std::optional<double> seconds_to_solve;
  double evaluations_spent = 0;  ///< mean per run
};

struct ContestResult {
  std::string name;
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
                                   const std::vector<Solver>& solvers, const ComparisonPlan& plan,
                                   Progress& progress);

/// How many runs `compare` will make.
std::size_t runs_of(const std::vector<Contest>& contests, const std::vector<Solver>& solvers,
                    const ComparisonPlan& plan);

}  // namespace ricochet::reproduction
