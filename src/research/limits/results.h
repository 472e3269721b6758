#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/report/json.h"
#include "src/research/limits/exclusions.h"
#include "src/research/limits/front_search.h"
#include "src/research/limits/grid.h"
#include "src/research/limits/judged.h"
#include "src/research/limits/order_bound.h"
#include "src/research/limits/symmetry.h"

namespace ricochet::studies::limits {

/// Length of the searches, and step of the evaluations.
struct Plan {
  carrier_track::Interpretation main;                 ///< whose fronts and claims are studied
  std::vector<carrier_track::Interpretation> others;  ///< of which some fronts are searched, too
  /// The main interpretation's fronts have the first first_constants, ... of these free, the
  /// others' five and all.
  std::vector<carrier_track::Unknown> order;
  std::size_t first_constants;
  std::vector<int> seeds;       ///< of the main interpretation's fronts and the long searches
  int population, generations;  ///< of a front
  std::vector<Solver>
      solvers;  ///< of the long searches; the first is also used for the others and for the rest
  std::int64_t long_evaluations;
  Solver near;                     ///< continues from the end of another search, with small steps
  std::int64_t near_evaluations;   ///< of each of these
  std::int64_t asked_evaluations;  ///< of each search for only some claims
  ExclusionPlan exclusion;
  Worth worth;
  int grid_steps;
  int symmetry_draws;
  double step;  ///< [rad/s] between the speeds of an evaluation
};

/// About twelve minutes on two cores.
Plan full_plan();

/// The same kind of report in seconds, without convergence.
Plan quick_plan();

/// Searches of one interpretation, with all its parameters free, for one number.
struct LongSearches {
  carrier_track::Interpretation interpretation;
  std::string target;
  std::vector<GoalSearch> searches;
  std::vector<GoalFound> found;
  std::vector<GoalFound> from_fronts;  ///< from the best point, by the number, of each seed's front
  Judged best;

  /// The number, by coarse cells: the lowest final value of a search, and the difference between
  /// the highest and the lowest of the searches from random points, or from the fronts.
  double lowest() const;
  double apart() const;
  double fronts_apart() const;
};

/// Searches for a subset of the claims, with all parameters of the main interpretation free.
struct Asked {
  ClaimGroup group;
  std::vector<GoalFound> found;  ///< one for each seed
  Judged best;
};

/// Thresholds of the machine of C1, C5 and C9 for disturbances between those cases.
struct ResponseCurve {
  std::string fit;
  std::vector<double> disturbances;  ///< [N]
  std::vector<double> thresholds;    ///< [rad/s]
};

struct Results {
  Plan plan;
  std::vector<carrier_track::Case> cases;  ///< with a threshold
  OrderBound ordered;                      ///< with the order that the paper concludes
  std::vector<Response> responses;
  OrderBound proportional;
  OrderBound indifferent;  ///< if the disturbance had no effect
  SymmetryChecks symmetries;
  std::vector<ChainedFront> fronts;
  std::vector<Judged> points;  ///< of the fronts, worth evaluating
  CoarseDoubt doubt;
  std::vector<LongSearches> long_searches;
  std::vector<Asked> asked;
  Exclusions exclusion;
  GridScan grid;
  std::vector<ResponseCurve> curves;
};

/// Computes everything that is missing in the store. The results depend only on the plan, not on
/// the number of threads.
Results limits(const Plan& plan, FitStore& store);

report::Json data_of(const Results& results);

}  // namespace ricochet::studies::limits
