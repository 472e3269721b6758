#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/report/json.h"
#include "src/studies/limits/exclusions.h"
#include "src/studies/limits/front_search.h"
#include "src/studies/limits/grid.h"
#include "src/studies/limits/judged.h"
#include "src/studies/limits/order_bound.h"
#include "src/studies/limits/symmetry.h"

namespace ricochet::studies::limits {

/// How long to search, and how closely to judge.
struct Plan {
  carrier_track::Reading main;                 ///< whose fronts and claims are looked into
  std::vector<carrier_track::Reading> others;  ///< of which some fronts are searched, too
  /// The main reading's fronts have first_constants, ... of these, the others' five and all.
  std::vector<carrier_track::Open> order;
  std::size_t first_constants;
  std::vector<int> seeds;       ///< of the main reading's fronts and the long searches
  int population, generations;  ///< of a front
  std::vector<Solver>
      solvers;  ///< of the long searches; the first also of the others' and the rest
  std::int64_t long_evaluations;
  Solver near;                     ///< goes on from where another search ended, with small steps
  std::int64_t near_evaluations;   ///< of each of these
  std::int64_t asked_evaluations;  ///< of each search for some claims alone
  ExclusionPlan exclusion;
  Worth worth;
  int grid_steps;
  int symmetry_draws;
  double step;  ///< [rad/s] between the speeds of a judgement
};

/// Some twelve minutes on two cores.
Plan full_plan();

/// The same kind of report in seconds: nothing converges.
Plan quick_plan();

/// Searches of one reading, with all its constants, for one number alone.
struct LongSearches {
  carrier_track::Reading reading;
  std::string target;
  std::vector<GoalSearch> searches;
  std::vector<GoalFound> found;
  std::vector<GoalFound> from_fronts;  ///< from the best by the number of each seed's front
  Judged best;

  /// The number itself, by coarse cells: the lowest that a search ends with, and how far the
  /// highest is from the lowest of the searches from anywhere, or from the fronts.
  double lowest() const;
  double apart() const;
  double fronts_apart() const;
};

/// Some claims asked for alone, with all constants of the main reading.
struct Asked {
  ClaimGroup group;
  std::vector<GoalFound> found;  ///< one a seed
  Judged best;
};

/// Thresholds of the machine of C1, C5 and C9 under disturbances between theirs.
struct ResponseCurve {
  std::string fit;
  std::vector<double> disturbances;  ///< [N]
  std::vector<double> thresholds;    ///< [rad/s]
};

struct Results {
  Plan plan;
  std::vector<carrier_track::Case> cases;  ///< with a threshold
  OrderBound ordered;                      ///< by what the paper concludes
  std::vector<Response> responses;
  OrderBound proportional;
  OrderBound indifferent;  ///< did the disturbance have no effect
  SymmetryChecks symmetries;
  std::vector<ChainedFront> fronts;
  std::vector<Judged> points;  ///< of the fronts, worth judging
  CoarseDoubt doubt;
  std::vector<LongSearches> long_searches;
  std::vector<Asked> asked;
  Exclusions exclusion;
  GridScan grid;
  std::vector<ResponseCurve> curves;
};

/// Computes everything that the store does not hold yet. The same plan gives the same results, on
/// any number of threads.
Results limits(const Plan& plan, FitStore& store);

report::Json data_of(const Results& results);

}  // namespace ricochet::studies::limits
