#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/paper/cases.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/report/json.h"
#include "src/studies/contest/catalogue.h"
#include "src/studies/contest/group.h"
#include "src/studies/reproduction/conclusions.h"
#include "src/studies/study.h"

namespace ricochet::studies::reproduction {

/// How finely to look, and how long.
struct StudyPlan {
  carrier_track::ScanOptions scan;
  double grid_step = 0;  ///< [rad/s] between the speeds at each point of the grid
  bool coarse_grid = false;
  /// What solvers are compared on: of its one part questions, solvers, forms, widths, instances and
  /// budgets; features, prices and seeds are those of a part that names none.
  Plan comparison;
};

/// Thresholds to 1e-3 rad/s, solvers as reports/plans/reproduction.toml has it: under half a minute
/// on two cores.
StudyPlan full_plan();

/// Thresholds to 1e-2 rad/s, solvers as reproduction_quick.toml beside it has it: a few seconds.
StudyPlan quick_plan();

inline constexpr std::size_t samples_of_a_path = 600;

/// A figure of the paper, computed: x(t) at its quiet speed and at its loud one.
struct FigurePaths {
  carrier_track::Recording quiet, loud;
};

/// A case of the paper, computed.
struct CaseStudy {
  carrier_track::Case the_case;
  carrier_track::Scene scene;
  carrier_track::SpeedScan scan;
  carrier_track::Score score;
  carrier_track::Staircase staircase;
  std::optional<FigurePaths> paths;  ///< where the paper has a figure
};

/// All that the report shows.
struct Results {
  StudyPlan plan;
  carrier_track::FittedReading reading;
  std::vector<CaseStudy> cases;
  CountGrid grid;
  std::vector<Trend> trends;
  contest::ContestPlan contest;
  std::vector<contest::Group> groups;  ///< of the contest's questions, by family
  std::vector<contest::Standing> standings;
};

/// Computes everything. The same plan gives the same results, but for the times in them.
Results results_of(const StudyPlan& plan, const Catalogue& catalogue);

/// What reports/templates/reproduction.toml asks for.
report::Json data_of(const Results& results);

/// How near the results come to the paper over all cases.
struct Agreement {
  int thresholds = 0;         ///< cases with a threshold both in the paper and computed
  double relative_error = 0;  ///< root mean square of ln(computed / paper) over these
  int examples = 0;           ///< speeds that the paper's figures show
  int right = 0;              ///< of these, on the side where the paper has them
};

Agreement agreement_of(const std::vector<CaseStudy>& cases);

}  // namespace ricochet::studies::reproduction

namespace ricochet::studies {

/// The cases of the paper, computed and set beside what the paper says of them.
Study reproduction_study();

}  // namespace ricochet::studies
