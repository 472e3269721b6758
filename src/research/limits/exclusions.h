#pragma once

#include <string>
#include <vector>

#include "src/studies/limits/claims.h"
#include "src/studies/limits/goal_search.h"

/// Which claim of the paper excludes which: one is dropped at a time, and the search goes on.
namespace ricochet::studies::limits {

struct ExclusionPlan {
  Solver solver;                   ///< that goes on from each of the starts
  std::int64_t evaluations;        ///< from each
  std::vector<int> control_seeds;  ///< of the searches that drop nothing; the first is that of all
};

/// What one claim costs the others.
struct Exclusion {
  ClaimGroup dropped;
  double its_share;     ///< what it adds to the misfit of the control's end
  double rest;          ///< the misfit of all others, where a control with as many evaluations ends
  double rest_without;  ///< the same, where the search that drops it ends
  /// What gains most from it, with how much, by falling gain; not what gains next to nothing.
  struct Gain {
    std::string name;
    double gain;
  };
  std::vector<Gain> gains;

  double relief() const { return rest - rest_without; }
};

struct Exclusions {
  double start;                  ///< misfit of the best start
  std::vector<double> controls;  ///< misfits that searches which drop nothing end with, by seed
  std::vector<Exclusion> all;    ///< by falling relief

  /// How far the controls' ends lie apart: what chance alone may make of a relief.
  double spread() const;
};

/// From each of the starts, which share a freedom.
Exclusions exclusions(const std::vector<Fit>& starts, const ExclusionPlan& plan, FitStore& store);

}  // namespace ricochet::studies::limits
