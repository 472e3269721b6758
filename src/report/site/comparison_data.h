#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/report/json.h"

/// The parts of a comparison's data.json that the front page reads.
namespace ricochet::site {

struct NamedSolver {
  std::string name;
  bool outside;
};

struct SpeedAccuracy {
  std::string family;            ///< or "all"
  std::optional<double> budget;  ///< nothing for all families
  bool largest;
  std::string solver, formulation;
  bool complete;
  std::optional<std::int64_t> problems;
  std::optional<double> evaluations, seconds, share, share_lower, share_upper, optimality_gap,
      optimality_gap_lower, optimality_gap_upper;
};

struct ComparisonData {
  std::int64_t runs;
  std::vector<NamedSolver> solvers;
  std::vector<SpeedAccuracy> speed_accuracy;
};

struct FamilyProblem {
  std::int64_t variables, constraints;
};

struct Rating {
  std::string solver, formulation;
  std::optional<double> best;  ///< nothing for one problem, or if no run solved its problem
  double share, lower, upper, returned;
  std::int64_t never;
  std::optional<double> rank;  ///< nothing if the entry takes fewer than half of the problems
};

struct Step {
  double evaluations, share;
};

struct Progress {
  std::string solver, formulation;
  std::vector<Step> progress;
};

struct RatedBudget {
  double budget;
  std::vector<Rating> ratings;
  std::vector<Progress> first;  ///< of the first ratings
};

struct MeasuredSimulation {
  double simulation;  ///< [s]
};

struct BreakEven {
  double budget;
  std::vector<MeasuredSimulation> here;
};

struct FamilyData {
  std::string family;
  std::vector<FamilyProblem> problems;
  std::vector<RatedBudget> budgets;
  std::vector<BreakEven> break_even_families;
};

RICOCHET_READ_FROM_JSON(NamedSolver, name, outside);
RICOCHET_READ_FROM_JSON(SpeedAccuracy, family, budget, largest, solver, formulation, complete,
                        problems, evaluations, seconds, share, share_lower, share_upper,
                        optimality_gap, optimality_gap_lower, optimality_gap_upper);
RICOCHET_READ_FROM_JSON(ComparisonData, runs, solvers, speed_accuracy);
RICOCHET_READ_FROM_JSON(FamilyProblem, variables, constraints);
RICOCHET_READ_FROM_JSON(Rating, solver, formulation, best, share, lower, upper, returned, never,
                        rank);
RICOCHET_READ_FROM_JSON(Step, evaluations, share);
RICOCHET_READ_FROM_JSON(Progress, solver, formulation, progress);
RICOCHET_READ_FROM_JSON(RatedBudget, budget, ratings, first);
RICOCHET_READ_FROM_JSON(MeasuredSimulation, simulation);
RICOCHET_READ_FROM_JSON(BreakEven, budget, here);
RICOCHET_READ_FROM_JSON(FamilyData, family, problems, budgets, break_even_families);

}  // namespace ricochet::site
