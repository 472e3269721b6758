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
  std::optional<std::string> needs;  ///< "nothing", or kinds of derivatives
  std::optional<std::string> kind;   ///< "fireworks", "derivatives", ...
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

/// The first entry of a family with a budget, of which only this is read.
struct LeadingEntry {
  std::string family;
  double budget;
  std::optional<bool> easy;      ///< true if random search is enough
  std::optional<double> random;  ///< evaluations that random search needs
};

struct ComparisonData {
  std::int64_t runs;
  std::vector<NamedSolver> solvers;
  std::vector<SpeedAccuracy> speed_accuracy;
  std::vector<LeadingEntry> leaders;
};

struct FamilyProblem {
  std::int64_t variables, constraints;
};

struct Rating {
  std::string solver, formulation;
  std::optional<std::int64_t> problems;  ///< that it takes
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
  std::vector<Progress> first;                 ///< of the first ratings
  std::optional<std::vector<Progress>> paper;  ///< of the paper's algorithm, if it is none of them
};

struct PerturbationName {
  std::string perturbation;
};

/// An entry on the problems of a family that are run under perturbations.
struct PerturbedEntry {
  report::Json shares;  ///< success rate under each perturbation, or null
  std::string family, solver, formulation;
  std::int64_t problems, least_variables, most_variables, runs;
  double budget;  ///< evaluations for each variable
};

struct PerturbedData {
  std::vector<PerturbationName> perturbation_names;
  std::vector<PerturbedEntry> perturbation_rows;
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

RICOCHET_READ_FROM_JSON(NamedSolver, name, outside, needs, kind);
RICOCHET_READ_FROM_JSON(SpeedAccuracy, family, budget, largest, solver, formulation, complete,
                        problems, evaluations, seconds, share, share_lower, share_upper,
                        optimality_gap, optimality_gap_lower, optimality_gap_upper);
RICOCHET_READ_FROM_JSON(LeadingEntry, family, budget, easy, random);
RICOCHET_READ_FROM_JSON(ComparisonData, runs, solvers, speed_accuracy, leaders);
RICOCHET_READ_FROM_JSON(FamilyProblem, variables, constraints);
RICOCHET_READ_FROM_JSON(Rating, solver, formulation, problems, best, share, lower, upper, returned,
                        never, rank);
RICOCHET_READ_FROM_JSON(Step, evaluations, share);
RICOCHET_READ_FROM_JSON(Progress, solver, formulation, progress);
RICOCHET_READ_FROM_JSON(RatedBudget, budget, ratings, first, paper);
RICOCHET_READ_FROM_JSON(PerturbationName, perturbation);
RICOCHET_READ_FROM_JSON(PerturbedEntry, shares, family, solver, formulation, problems,
                        least_variables, most_variables, runs, budget);
RICOCHET_READ_FROM_JSON(PerturbedData, perturbation_names, perturbation_rows);
RICOCHET_READ_FROM_JSON(MeasuredSimulation, simulation);
RICOCHET_READ_FROM_JSON(BreakEven, budget, here);
RICOCHET_READ_FROM_JSON(FamilyData, family, problems, budgets, break_even_families);

}  // namespace ricochet::site
