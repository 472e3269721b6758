#pragma once

#include <string>
#include <vector>

#include "src/core/question.h"
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

/// How a solver did on one question; one entry a run in every list.
struct Standing {
  std::string solver;
  std::string form;                          ///< that it was shown
  int failed = 0;                            ///< runs that ended in an exception
  std::vector<double> regrets;               ///< infinite where a run found nothing feasible; below
                                             ///< 0 where it found a new best value
  std::vector<Effort> evaluations, seconds;  ///< until solved, or in all
};

/// One question, put to all solvers: each gets the first form that it accepts.
struct ContestResult {
  Question question;
  std::vector<Standing> standings;
  std::vector<Progression> by_evaluations;
  std::vector<Progression> by_seconds;
};

struct ComparisonPlan {
  int instances = 15;
  Budget budget;
};

/// Runs every solver on instances 1..n of every question, whose best values must be known, in
/// parallel, and sums up.
std::vector<ContestResult> compare(const std::vector<Question>& questions,
                                   const std::vector<Solver>& solvers, const ComparisonPlan& plan);

}  // namespace ricochet::studies::reproduction
