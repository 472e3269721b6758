#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/counting/certainty.h"
#include "problems/carrier_track/suite/cases.h"
#include "src/report/json.h"

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

/// All cases with one stiffness.
struct FidelityTotal {
  std::string stiffness = {};
  int compared = 0;
  int equal = 0;
  std::optional<double> share = {},
                        distance = {};  ///< equal, and the mean distance, of those compared
  int unfinished = 0;
  std::optional<double> least_cost = {}, most_cost = {};  ///< of a case
};
RICOCHET_FIELDS(FidelityTotal, stiffness, compared, equal, share, distance, unfinished, least_cost,
                most_cost);

struct FidelityShares {
  std::string case_;
  std::vector<std::optional<double>> equal;  ///< one for each stiffness
};
RICOCHET_FIELDS(FidelityShares, case_, equal);

struct TriedSpeeds {
  std::size_t tried;
  double first, last;  ///< [rad/s]
};
RICOCHET_FIELDS(TriedSpeeds, tried, first, last);

struct FidelityData {
  std::size_t cases;
  TriedSpeeds speeds;
  std::vector<FidelityTotal> stiffnesses;
  std::vector<FidelityShares> shares;
};
RICOCHET_FIELDS(FidelityData, cases, speeds, stiffnesses, shares);

/// Where the counts of compliant and hard walls differ.
FidelityData data_of(const FidelityStudy& study);

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

/// All cases with one direction of the yarn.
struct LevelDirection {
  double tangent, coupled, wrong;  ///< the latter two as shares of the speeds
};
RICOCHET_FIELDS(LevelDirection, tangent, coupled, wrong);

/// How certain a case's counts are, and the reasons if they are not.
struct LevelCase {
  std::string case_;
  int speeds;
  double certain;  ///< share
  int margin, window, graze, sensitive, resolved;
};
RICOCHET_FIELDS(LevelCase, case_, speeds, certain, margin, window, graze, sensitive, resolved);

/// Processor time of a count relative to hard walls in one direction.
struct LevelCosts {
  std::string case_;
  double compliant, planar, automatic;
};
RICOCHET_FIELDS(LevelCosts, case_, compliant, planar, automatic);

struct WrongShares {
  std::string case_;
  std::vector<double> shares;  ///< one for each direction
};
RICOCHET_FIELDS(WrongShares, case_, shares);

struct LevelData {
  double stiffness = {};
  std::vector<LevelDirection> directions = {};
  std::vector<LevelCase> cases = {};
  std::vector<LevelCosts> costs = {};
  std::vector<WrongShares> wrong = {};
  int speeds = 0, certain = 0;
  double certain_share = 0;
  int uncertain = 0, resolved = 0;
};
RICOCHET_FIELDS(LevelData, stiffness, directions, cases, costs, wrong, speeds, certain,
                certain_share, uncertain, resolved);

/// Which level a scene needs, the errors of the cheaper ones, and the cost of each.
LevelData data_of(const LevelStudy& study);

/// A level of the model over all cases: its cost, and how often its count differs from that of hard
/// walls in one direction, the reference.
struct LevelCost {
  std::string level;
  bool reference;
  std::optional<double> cost, wrong;  ///< processor time over that of the reference; a share
};
RICOCHET_FIELDS(LevelCost, level, reference, cost, wrong);

/// Whether the second direction is needed.
struct PlanarNeed {
  double most_wrong;       ///< largest share of wrong counts without it
  double largest_tangent;  ///< of the pull across to the pull along
};
RICOCHET_FIELDS(PlanarNeed, most_wrong, largest_tangent);

std::vector<LevelCost> level_costs(const FidelityData& walls, const LevelData& levels);
PlanarNeed planar_need(const LevelData& levels);

// The fastest quiet speed by every method of simulation: its cost and its error.

/// [rad/s] Largest error of the fastest quiet speed that counts as solved, as in problems of top
/// speed.
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

/// Cost and error of one method of simulation over the cases.
struct SimulationRow {
  std::string simulation, kind, control;
  bool reference;
  double seconds;  ///< per simulation: geometric mean of the cases
  std::optional<double> seconds_least, seconds_most;
  std::optional<double> error, error_least;  ///< [rad/s], largest and smallest; none if any missing
  int missing, unfinished;
  bool within;
};
RICOCHET_FIELDS(SimulationRow, simulation, kind, control, reference, seconds, seconds_least,
                seconds_most, error, error_least, missing, unfinished, within);

struct ReferenceThreshold {
  std::string case_;
  std::optional<double> threshold;  ///< [rad/s]
};
RICOCHET_FIELDS(ReferenceThreshold, case_, threshold);

struct ThresholdData {
  std::string family = {};  ///< of problems whose answers are the thresholds
  std::vector<std::string> formulations =
      {};                               ///< of these, those in which an evaluation is a simulation
  std::vector<std::string> names = {};  ///< of the cases
  std::vector<ReferenceThreshold> cases = {};
  double tolerance = {};
  std::vector<SimulationRow> simulations = {};
  std::optional<SimulationRow> cheapest = {};  ///< of those within the tolerance
  double level = 0;
  int within = 0;
  std::size_t tried = 0;
};
RICOCHET_FIELDS(ThresholdData, family, formulations, names, cases, tolerance, simulations, cheapest,
                level, within, tried);

/// Cost and error of every simulation.
ThresholdData data_of(const ThresholdStudy& study);

}  // namespace ricochet::studies::dynamics
