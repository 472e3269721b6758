#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ricochet/scene.h"
#include "src/report/results.h"

/// Does a motion forget its start, or is it chaotic? Uses exact derivatives instead of pairs of
/// runs.
namespace ricochet::studies::dynamics {

/// A small difference of two motions under the same forces.
struct Difference {
  double position;  ///< [m]
  double velocity;  ///< [m/s]
};

/// Returns the difference, to first order, at the end of the window of a valid scene of hard walls
/// whose start differs by `start`; nothing once the body has rested on a wall, after which there is
/// none. The product of exact derivatives: [[1, t], [0, 1]] of a flight, the saltation matrices
/// [[-e, 0], [(a+ + e a-) / v-, -e]] of an impact and diag(1, a+ / a-) of a velocity zero, where a
/// is the acceleration before and after: a+ is 0 for a rest in the gap. An impact at speed zero has
/// no derivative; its time is treated as constant.
std::optional<Difference> carried(const carrier_track::Scene& scene, const Difference& start);

/// Evolution of a small difference in a long window. Its length is hypot(position [m], velocity /
/// rate [m]), with the rate [rad/s] of the fastest force.
struct Sensitivity {
  /// Mean rate of ln(length) while the body does not rest on a wall [1/s], and its standard error,
  /// from ten equal parts of the window without its first tenth, in which the motion settles.
  double growth, growth_error;
  double impacts;        ///< [1/s], over the same time
  double rests_on_wall;  ///< [1/s], over the whole window: each removes the difference
  double digits_lost;    ///< largest log10 of the growth since the start or the last rest on a wall

  /// Largest Lyapunov exponent [1/s]; nothing, meaning minus infinity, if the body rests on a wall.
  std::optional<double> exponent() const {
    return rests_on_wall > 0 ? std::nullopt : std::optional(growth);
  }
  /// The exponent is positive beyond three standard errors.
  bool chaotic() const { return exponent() && growth > 3 * growth_error; }
  /// Number of impacts until a difference of one rounding, 2^-53, has grown to one, at the mean
  /// rate; nothing if differences do not grow.
  std::optional<double> impacts_foretold() const;
};

/// Of a valid scene of hard walls.
Sensitivity sensitivity_of(const carrier_track::Scene& scene);

/// log10 of the growth of a difference since the start or the last rest on a wall, just before each
/// of the first `impacts` impacts.
std::vector<double> digits_lost_by_impact(const carrier_track::Scene& scene, std::size_t impacts);

/// Number of impacts after which two runs whose start velocities differ by one rounding diverge:
/// they hit different walls, or differ by more than a tenth of the mean time between impacts.
/// Nothing if they never do.
std::optional<int> impacts_until_parted(const carrier_track::Scene& scene);

struct LyapunovPlan {
  std::vector<double> speeds;  ///< [rad/s], of the paper's cases
  double turns;                ///< of the driver plate, window of each
  int starts;                  ///< pairs of runs that may diverge
};

/// A motion that is studied in detail.
struct Course {
  std::string name;
  Sensitivity sensitivity;
  double impacts;                   ///< in its window, approximately
  std::vector<double> digits_lost;  ///< by impact
  std::vector<int> parted;          ///< impacts until pairs of runs diverged, for those that did
};

struct LyapunovStudy {
  LyapunovPlan plan;
  std::vector<std::string> cases;               ///< ids
  std::vector<std::vector<Sensitivity>> cells;  ///< a row for each case, a cell for each speed
  std::vector<Course> courses;                  ///< C2, C10, and the chaotic scene
};

/// Every case of the paper, and the courses.
LyapunovStudy study_lyapunov(const LyapunovPlan& plan);

/// Adds which motions are chaotic, and for how many impacts a simulation can be trusted.
void add_to(report::Results& results, const LyapunovStudy& study);

}  // namespace ricochet::studies::dynamics
