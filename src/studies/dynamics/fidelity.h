#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/counting/certainty.h"
#include "problems/carrier_track/suite/cases.h"
#include "src/report/results.h"

/// Hard against compliant walls: does the count differ, and at what cost?
namespace ricochet::studies::dynamics {

/// One case of the paper with one stiffness over several speeds.
struct FidelityCell {
  int equal = 0;     ///< speeds with equal counts
  int distance = 0;  ///< sum of the count differences over the speeds
  int compared = 0;  ///< speeds at which the compliant simulation finished
  /// Processor time of the compliant simulations over that of the hard ones; nothing if there are
  /// none.
  std::optional<double> cost;

  std::optional<double> share() const {
    return compared > 0 ? std::optional(static_cast<double>(equal) / compared) : std::nullopt;
  }
};

struct FidelityPlan {
  std::vector<double> speeds;       ///< [rad/s]
  std::vector<double> stiffnesses;  ///< [N/m^1.5]
};

struct FidelityStudy {
  FidelityPlan plan;
  std::vector<std::string> cases;                ///< ids
  std::vector<std::vector<FidelityCell>> cells;  ///< a row for each case, a cell for each stiffness
};

/// Every case of the paper, with the law exact-restitution.
FidelityStudy study_fidelity(const FidelityPlan& plan);

/// All cases with one stiffness: a row of the table "walls".
struct FidelityTotal {
  int compared = 0, equal = 0, unfinished = 0;
  double distance = 0;                                    ///< sum of the count differences
  std::optional<double> least_cost = {}, most_cost = {};  ///< of a case

  std::optional<double> share() const {
    return compared > 0 ? std::optional(static_cast<double>(equal) / compared) : std::nullopt;
  }
};

/// Adds where the counts of compliant and hard walls differ.
void add_to(report::Results& results, const FidelityStudy& study);

// Which level of the model does a scene need? Errors of the cheaper levels, and the cost of each.

struct LevelPlan {
  double step;                     ///< [rad/s] of the speeds, up to 18
  std::vector<double> directions;  ///< tan phi of the yarn; with 0 it pulls along x alone
  double stiffness;                ///< [N/m^1.5] of the compliant level, law exact-restitution
  std::size_t cost_stride;         ///< every how many speeds all levels are timed
};

/// One case over all speeds.
struct LevelRow {
  std::string id;
  int speeds = 0;
  int certain = 0;                  ///< counts that the impact level is certain of
  int resolved = 0;                 ///< the others of which the compliant level is certain
  std::array<int, 6> doubts{};      ///< of the impact level, by Doubt
  std::vector<int> coupled;         ///< for each direction: speeds that need both directions
  std::vector<int> wrong;           ///< of those, speeds where the count of x alone differs
  std::array<double, 4> seconds{};  ///< processor time of impact, compliant, planar, auto
};

/// The machine of a case at each level: with a second direction in which the yarn pulls by
/// `direction` times its pull along x. The planar level has no contact_friction; it is in the
/// restitution instead, which is the same along x.
carrier_track::Scene level_scene(const carrier_track::Case& the_case, double direction,
                                 double stiffness);

struct LevelStudy {
  LevelPlan plan;
  std::vector<LevelRow> rows;  ///< one for each case
};

/// Studies every case of the paper in the default interpretation. The second direction, which is
/// not in the paper's objective, has the clearance of the first, with the carrier in its middle.
LevelStudy study_levels(const LevelPlan& plan);

/// Adds which level a scene needs, the errors of the cheaper ones, and the cost of each, those of
/// compliant walls too.
void add_to(report::Results& results, const LevelStudy& study, const FidelityStudy& walls);

// The top speed in the window by every method of simulation: its cost and its error.

/// [rad/s] Largest error of the top speed in the window that counts as solved, as in problems of
/// top speed.
inline constexpr double found_within = 0.01;

struct ThresholdPlan {
  std::vector<std::string> cases;   ///< ids
  double grid;                      ///< [rad/s], of the speeds, tried from the fastest down
  double timed_grid;                ///< [rad/s], of the speeds whose simulations are timed
  std::vector<double> stiffnesses;  ///< [N/m^1.5] of compliant walls
  std::vector<double> tolerances;   ///< relative, of methods with adaptive steps
  std::vector<double> steps;        ///< [s], of methods with fixed steps
};

/// One method of simulation in one case.
struct CaseThreshold {
  std::optional<double> speed;  ///< [rad/s], the fastest quiet one; nothing if there is none
  double seconds = 0;           ///< of processor time, mean over the timed speeds
  int simulations = 0;
  int unfinished = 0;  ///< number of these that did not finish; they count as loud
};

struct SimulatedThresholds {
  std::string simulation;            ///< level of the model, or method
  std::string kind;                  ///< "level", "variable steps" or "fixed steps"
  std::string control;               ///< as text; empty if it has none
  std::vector<CaseThreshold> cases;  ///< in the order of the plan
};

struct ThresholdStudy {
  ThresholdPlan plan;
  std::vector<SimulatedThresholds> simulations;  ///< hard walls in closed form first: the reference
};

/// The cases of the paper in the default interpretation. Scans from 18 rad/s down to the first
/// quiet speed of the grid, then bisects. The results are reproducible, except for the times.
ThresholdStudy study_thresholds(const ThresholdPlan& plan,
                                const std::vector<carrier_track::Integrator>& integrators);

/// Adds cost and error of every simulation.
void add_to(report::Results& results, const ThresholdStudy& study);

}  // namespace ricochet::studies::dynamics
