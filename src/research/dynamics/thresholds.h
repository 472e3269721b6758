#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/check/reference_integrators/integrator.h"
#include "src/report/json.h"

/// The fastest quiet speed by every method of simulation: its cost and its error.
namespace ricochet::studies::dynamics {

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
RICOCHET_WRITTEN_AS_JSON(SimulationRow, simulation, kind, control, reference, seconds,
                         seconds_least, seconds_most, error, error_least, missing, unfinished,
                         within);

struct ReferenceThreshold {
  std::string case_;
  std::optional<double> threshold;  ///< [rad/s]
};
RICOCHET_WRITTEN_AS_JSON(ReferenceThreshold, case_, threshold);

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
RICOCHET_WRITTEN_AS_JSON(ThresholdData, family, formulations, names, cases, tolerance, simulations,
                         cheapest, level, within, tried);

/// Cost and error of every simulation.
ThresholdData data_of(const ThresholdStudy& study);

}  // namespace ricochet::studies::dynamics
