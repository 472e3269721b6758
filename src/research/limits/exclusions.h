#pragma once

#include <string>
#include <vector>

#include "src/research/limits/claims.h"
#include "src/research/limits/goal_search.h"

/// Conflicts between claims of the paper: one claim is dropped at a time, and the search is
/// continued.
namespace ricochet::studies::limits {

struct ExclusionPlan {
  Solver solver;                   ///< continues from each of the starts
  std::int64_t evaluations;        ///< from each
  std::vector<int> control_seeds;  ///< of the searches that drop nothing; others use the first
};

/// How much one claim increases the loss of the others.
struct Exclusion {
  ClaimGroup dropped;
  double its_share;     ///< its contribution to the final loss of the control
  double rest;          ///< final loss of all others in a control with as many evaluations
  double rest_without;  ///< the same, at the end of the search that drops it
  /// The claim that improves, and by how much; sorted by falling gain, without negligible gains.
  struct Gain {
    std::string name;
    double gain;
  };
  std::vector<Gain> gains;

  double relief() const { return rest - rest_without; }
};

struct Exclusions {
  double start;                  ///< loss of the best start
  std::vector<double> controls;  ///< final losses of the searches that drop nothing, by seed
  std::vector<Exclusion> all;    ///< by falling relief

  /// Spread of the controls' final losses: a relief of this size can be due to chance.
  double spread() const;
};

/// Continues from each of the starts, which have the same free parameters.
Exclusions exclusions(const std::vector<Fit>& starts, const ExclusionPlan& plan, FitStore& store);

}  // namespace ricochet::studies::limits
