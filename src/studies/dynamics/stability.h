#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/check/integrator.h"
#include "src/report/results.h"

/// Where penalty methods fail on stiff walls: maps over stiffness and step or tolerance.
namespace ricochet::studies::dynamics {

/// The behaviour of a run compared with a reference; the last one that applies.
enum class Behaviour {
  right_count,      ///< as many counted impacts as the reference
  too_many,         ///< spurious impacts
  too_few,          ///< impacts missed
  gains_energy,     ///< a wall returned a body faster than its approach
  gives_up,         ///< too many steps, or no step small enough
  leaves_the_walls  ///< by more than the gap, or not finite
};

/// Classifies a run of `scene` against a finished reference run.
Behaviour behaviour_of(const carrier_track::Scene& scene, const carrier_track::Outcome& outcome,
                       const carrier_track::Outcome& reference);

struct StabilityCell {
  Behaviour behaviour;
  double evaluations;  ///< of the force, per impact of the reference
};

struct StabilityMap {
  std::string method;
  std::string control;                            ///< meaning and unit of the controls
  std::vector<double> controls;                   ///< from loose to tight
  std::vector<std::vector<StabilityCell>> cells;  ///< by stiffness (rows) and control (cells)
};

/// h w below which an explicit method stays bounded on a spring of frequency w [rad/s], h [s] the
/// step: 2 for semi-implicit Euler, sqrt(8) for Runge-Kutta 4; nothing for other methods. Hairer,
/// Lubich and Wanner, Geometric Numerical Integration, I.5; Hairer and Wanner, Solving Ordinary
/// Differential Equations II, IV.2.
std::optional<double> spring_bound(const std::string& method);

/// w [rad/s] of a wall at the peak penetration of an impact with `speed` [m/s]: the square root of
/// n K d^(n-1) / m.
double peak_frequency(const carrier_track::Scene& scene, double speed);

/// The step at the stability limit as h w, over all stiffnesses.
struct Border {
  double highest_good;  ///< of a cell that neither gains energy nor leaves the walls
  double lowest_bad;    ///< of one that does
};

/// Cost of lying pressed on a wall for rest_seconds [s], at a tolerance of rest_tolerance.
inline constexpr double rest_seconds = 0.3;
inline constexpr double rest_tolerance = 1e-6;
struct Rest {
  double evaluations;                 ///< of the force
  std::optional<double> depth_error;  ///< relative, at the end; nothing if it gave up
};
struct RestCost {
  std::string method;
  std::vector<Rest> rests;  ///< one for each stiffness
};

struct StabilityPlan {
  std::vector<double> stiffnesses;  ///< [N/m^1.5]
  std::vector<double> steps;        ///< [s], falling
  std::vector<double> tolerances;   ///< falling
};

/// Decades of stiffness, quarters of a decade of the step; about 12 seconds.
StabilityPlan full_stability_plan();

/// Coarser: one second.
StabilityPlan quick_stability_plan();

struct StabilityStudy {
  StabilityPlan plan;
  std::vector<double>
      frequencies;  ///< [rad/s], one for each stiffness: peak_frequency at its fastest impact
  std::vector<StabilityMap> maps;  ///< one for each penalty method
  StabilityMap hard;               ///< Moreau-Jean on hard walls: one row
  std::vector<RestCost> rests;     ///< one for each adaptive method
};

/// The cheapest cell of a row from which on every tighter control counts right; nothing if the
/// tightest does not.
std::optional<StabilityCell> cheapest_right(const std::vector<StabilityCell>& row);

StabilityMap map_of(const carrier_track::Integrator& integrator, const StabilityPlan& plan);
Border border_of(const StabilityMap& map, const std::vector<double>& frequencies);
RestCost rest_cost(const carrier_track::Integrator& integrator,
                   const std::vector<double>& stiffnesses);

StabilityStudy study_stability(const StabilityPlan& plan);

/// Adds where penalty methods count wrong, gain energy or give up.
void add_to(report::Results& results, const StabilityStudy& study);

}  // namespace ricochet::studies::dynamics
