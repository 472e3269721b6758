#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/experiment/stored_campaign.h"
#include "src/report/results.h"
#include "src/report/site/study.h"
#include "src/studies/paper/interpretation.h"

namespace ricochet::studies {

/// Computes the cases of the paper and compares them with its claims, and solvers on problems of
/// these cases. The runs of the solvers are stored in comparison.sqlite in this folder.
Study reproduction_study(const std::filesystem::path& folder, const Provenance& provenance);

}  // namespace ricochet::studies

namespace ricochet::studies::reproduction {

/// Resolution of the study.
struct StudyPlan {
  carrier_track::ScanOptions scan;
  double grid_step;  ///< [rad/s] between the speeds at each point of the grid
  bool coarse;       ///< fewer points of the grid and of the curves
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
};

std::vector<CaseStudy> study_cases(const carrier_track::Scene& interpretation,
                                   const carrier_track::ScanOptions& options);

/// What the page reproduction.md is filled with, but for the comparison of solvers. It depends only
/// on the plan.
report::Results results_of(const StudyPlan& plan);

// The sections of the page: each adds its values, tables and charts. Speeds are in rad/s, errors
// and shares are fractions.

/// How far the thresholds agree with the paper's, by the paper's rule and in the long run.
void add_thresholds(const std::vector<CaseStudy>& cases, std::size_t fitted,
                    report::Results& results);

/// Whether the count makes a step at the threshold, and what is below it.
void add_steps(const std::vector<CaseStudy>& cases, report::Results& results);

/// What moves the fastest quiet speed: exponents of the cases without disturbance, and curves over
/// the counting limit and the restitution, up to the speed `highest`.
void add_levers(const std::vector<CaseStudy>& cases,
                const carrier_track::FittedInterpretation& interpretation, bool coarse,
                double highest, report::Results& results);

/// The mean collision count over evenly spaced speeds of 0..18 rad/s, `step` apart, on a grid of
/// restitution, friction and disturbance, which are columns beside mean. Parallel.
Table count_grid(const carrier_track::Scene& interpretation, double step, bool coarse);

/// The paper's conclusions between neighbours on the grid, each along lines on which all else is
/// constant: the count (A) rises with restitution, without disturbance; (B) falls with friction,
/// without disturbance; (C) rises with the disturbance. Adds the table conclusions and the chart
/// grid.
void add_conclusions(const Table& grid, report::Results& results);

/// How much of the thresholds, the paper's and the computed ones, simple formulas explain.
void add_theory(const std::vector<CaseStudy>& cases, report::Results& results);

/// One value must not be greater than another; both by index.
struct AtMost {
  std::size_t lower, upper;
};

/// Distance between given values and the nearest values that satisfy constraints.
struct OrderBound {
  double root_mean_square;           ///< least root mean square distance
  double largest;                    ///< least largest distance; generally of other values
  std::vector<double> nearest = {};  ///< the values of the least mean square
};

/// Isotonic regression over a partial order, in closed form: the nearest value at i is the maximum,
/// over upper sets U with i, of the minimum, over lower sets L with i, of the mean of the
/// intersection of U and L (Robertson, Wright and Dykstra, Order Restricted Statistical Inference,
/// 1988, theorem 1.4.4); the least largest distance is half the largest violation. At most 16
/// values.
OrderBound isotonic_bound(const std::vector<double>& values, const std::vector<AtMost>& order);

/// The same for logarithms of thresholds of a machine at three disturbances, 0 first, that are
/// linear or concave in the disturbance, as the first order of any smooth dependence is:
/// the one in the middle must not lie below the chord, which divides at `share`.
OrderBound concave_bound(const std::vector<double>& three, double share);

/// How close any model can come to the paper's thresholds, whatever its equations: lower bounds, in
/// closed form, on the error of ln(threshold) if thresholds are ordered as the paper concludes, if
/// they fall in proportion to the disturbance or faster, and if they do not depend on it.
void add_bounds(report::Results& results);

/// The best solvers of each family of problems, and the paper's, by reports/plans/reproduction.toml
/// or reproduction_quick.toml. Computes the runs that are missing in the store, which is replaced
/// if it is of another plan, program or data.
void add_solvers(bool quick, const std::filesystem::path& store, const Provenance& provenance,
                 report::Results& results);

/// The interpretation's parameters.
void add_interpretation(const carrier_track::FittedInterpretation& interpretation,
                        report::Results& results);

/// A part for each case: its counts over the speed, and x(t) at the speeds of the paper's figures.
/// The speed and the acceleration of a crossing (Figure 3).
void add_pictures(const std::vector<CaseStudy>& cases, report::Results& results);

/// The regimes over the restitution of the cases without disturbance, by rising friction.
void add_maps(const std::vector<CaseStudy>& cases, report::Results& results);

}  // namespace ricochet::studies::reproduction
