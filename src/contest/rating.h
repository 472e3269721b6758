#pragma once

#include <string>
#include <vector>

#include "src/contest/contest.h"
#include "src/statistics/interval.h"

namespace ricochet::contest {

/// Share of the pairs of question and target that a competitor reached within so many evaluations
/// for each variable, with its interval over questions.
struct Reach {
  double evaluations;
  double share;
  Interval interval;
};

/// What a solver shown one form can do on a group of questions with one budget.
struct Rating {
  std::string solver;
  std::string form;
  int questions = 0;                     ///< that it takes in this form
  int never = 0;                         ///< of these, those that no run solved
  double found = 0;                      ///< share of runs solved, mean over the questions
  double handed_over = 0;                ///< the same of the points that were handed over
  std::vector<Reach> progress;           ///< the empirical distribution of hitting times
  double probability_of_being_best = 0;  ///< Plackett and Luce's model of all questions' rankings
  double rank = 0;                       ///< mean over questions and instances, ties sharing theirs
};

/// How tables and charts name a solver that is shown a form.
inline std::string competitor(const std::string& solver, const std::string& form) {
  return solver + ", " + form;
}

/// Regrets that count as targets of a question: its own tolerance, and easier ones.
std::vector<double> targets_of(const Question& question);

/// Rates all that took part with budget `budget` of the plan on these questions (indices): the one
/// that is best with the highest probability first, equals by their mean rank. On every instance
/// the competitors are ranked by the best regret and then by what it cost.
std::vector<Rating> rate(const ContestPlan& plan, const std::vector<Standing>& standings,
                         const std::vector<std::size_t>& questions, std::size_t budget);

}  // namespace ricochet::contest
