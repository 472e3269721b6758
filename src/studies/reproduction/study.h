#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/analysis/statistics/intervals.h"
#include "src/experiment/stored_campaign.h"
#include "src/report/results.h"
#include "src/report/site/study.h"
#include "src/studies/paper/interpretation.h"
#include "src/studies/reproduction/conclusions.h"
#include "src/studies/reproduction/levers.h"

namespace ricochet::studies::reproduction {

/// Resolution and length of the study.
struct StudyPlan {
  carrier_track::ScanOptions scan;
  double grid_step = 0;  ///< [rad/s] between the speeds at each point of the grid
  bool coarse_grid = false;
  Plan comparison;  ///< of solvers: one part, without perturbations
};

/// Thresholds to 1e-3 rad/s, solvers as in reports/plans/reproduction.toml: under half a minute on
/// two cores.
StudyPlan full_plan();

/// Thresholds to 1e-2 rad/s, solvers as in reproduction_quick.toml in the same folder: a few
/// seconds.
StudyPlan quick_plan();

inline constexpr std::size_t samples_of_a_path = 600;

/// A figure of the paper, computed: x(t) at its quiet speed and at its loud one.
struct FigurePaths {
  carrier_track::Recording quiet, loud;
};

/// The borders of a case in the long run [rad/s]; nothing if it is louder at the slowest speed.
struct LongRunBorders {
  std::optional<double> silent;     ///< no turn has a collision up to this speed
  std::optional<double> quiet;      ///< no turn has more than quiet_per_turn collisions
  std::optional<double> loud_from;  ///< every turn has more from this speed on
};

/// A case of the paper, computed.
struct CaseStudy {
  carrier_track::Case the_case;
  carrier_track::Scene scene;
  LongRunBorders borders;
  carrier_track::SpeedScan scan;
  carrier_track::Score score;
  carrier_track::Staircase staircase;
  std::optional<FigurePaths> paths;  ///< if the paper has a figure
};

/// What the report is made of.
struct Findings {
  StudyPlan plan;
  carrier_track::FittedInterpretation interpretation;
  std::vector<CaseStudy> cases;
  CountGrid grid;
  std::vector<Trend> trends;
  /// The regimes over the restitution of the cases without disturbance, by rising friction.
  std::vector<report::Chart> maps;
  Levers levers;
  std::optional<StoredCampaign> comparison;  ///< of solvers, if it has been run
};

/// Where the comparison of solvers is stored.
struct ComparisonStore {
  std::filesystem::path file;
  Provenance provenance;
};

/// Computes everything; for the comparison only the runs missing in its store. A store of another
/// plan, program or data is replaced. The results depend only on the plan, except for the times.
Findings findings_of(const StudyPlan& plan, const Catalogue& catalogue,
                     const ComparisonStore& store);

/// What the page reproduction.md is filled with.
report::Results results_of(const Findings& findings);

/// Agreement of the results with the paper over all cases.
struct Agreement {
  int thresholds = 0;                ///< cases with a threshold both in the paper and computed
  double relative_error = 0;         ///< root mean square of ln(computed / paper) over these
  std::optional<Interval> interval;  ///< of 95 %, from samples of these cases; none without a case
  int examples = 0;                  ///< speeds in the paper's figures
  int right = 0;                     ///< of these, on the same side as in the paper
};

Agreement agreement_of(const std::vector<CaseStudy>& cases);

}  // namespace ricochet::studies::reproduction

namespace ricochet::studies {

/// Computes the cases of the paper and compares them with its claims. The runs of its comparison of
/// solvers are stored in comparison.sqlite in this folder.
Study reproduction_study(const std::filesystem::path& folder, const Provenance& provenance);

}  // namespace ricochet::studies
