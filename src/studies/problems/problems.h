#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "src/analysis/statistics/intervals.h"
#include "src/report/json.h"
#include "src/report/site/study.h"

namespace ricochet::studies::problems {

/// How hard a problem is for a solver that knows nothing: from points uniform in the box.
struct Difficulty {
  /// Share of the box whose points are feasible and within the tolerance of the best known value,
  /// in [0, 1], with a 95 % interval.
  double solving_share;
  Interval interval;
  double feasible_share;  ///< in [0, 1]; 1 without constraints
  /// Expected evaluations of random search until it solves the problem; empty if no point did.
  std::optional<double> random_search;
  /// Median distance, along one coordinate and in widths of the box, over which what is simulated
  /// stays the same: the constraints, or the objective if there are none. Not above 1.
  double plateau;
};

/// Samples the problem at `points` >= 1 points, and its plateaus at a twentieth of them.
/// Deterministic in the problem's name. Returns nothing if no best value is known.
std::optional<Difficulty> difficulty_of(const Problem& problem, int points);

/// The data for the page of a family with at least one problem. How hard each problem is rests on
/// this many simulations at least, >= 1.
report::Json family_data(const Family& family, int simulations);

/// The family's row in the table of all families.
report::Json family_row(const Family& family);

}  // namespace ricochet::studies::problems

namespace ricochet::studies {

/// Pages that describe problems: one of all families, and one for each. `families` makes them when
/// the study runs. `scene_file` is the file of the machine whose problems they are, or empty.
Study problems_study(const std::function<std::vector<Family>()>& families,
                     const std::string& scene_file);

}  // namespace ricochet::studies
