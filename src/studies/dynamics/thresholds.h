#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/reference_integrators/integrator.h"
#include "src/report/json.h"

/// The fastest quiet speed by every way to simulate the motion: what it costs, and how wrong it is.
namespace ricochet::studies::dynamics {

/// [rad/s] from the fastest quiet speed at which it counts as found, as in questions of top speed.
inline constexpr double found_within = 0.01;

struct ThresholdPlan {
  std::vector<std::string> cases;   ///< ids
  double grid;                      ///< [rad/s], of the speeds that are tried from the fastest down
  double timed_grid;                ///< [rad/s], of the speeds whose simulations are timed
  std::vector<double> stiffnesses;  ///< [N/m^1.5] of compliant walls
  std::vector<double> tolerances;   ///< relative, of methods that choose their steps
  std::vector<double> steps;        ///< [s], of methods that do not
};

/// One way to simulate, in one case.
struct CaseThreshold {
  std::optional<double> speed;  ///< [rad/s], the fastest quiet one; nothing where none is
  double seconds = 0;           ///< of processor time, mean over the speeds that are timed
  int simulations = 0;
  int unfinished = 0;  ///< of these; they are taken for loud
};

struct SimulatedThresholds {
  std::string simulation;            ///< level of the model, or method
  std::string kind;                  ///< "level", "variable steps" or "fixed steps"
  std::string control;               ///< as text; empty where there is none
  std::vector<CaseThreshold> cases;  ///< in the order of the plan
};

struct ThresholdStudy {
  ThresholdPlan plan;
  std::vector<SimulatedThresholds> simulations;  ///< first hard walls in closed form: the reference
};

/// The cases of the paper in the default reading. From 18 rad/s down to the first quiet speed of
/// the grid, then by bisection. All but the times is the same every time.
ThresholdStudy study_thresholds(const ThresholdPlan& plan,
                                const std::vector<carrier_track::Integrator>& integrators);

/// Cost and error of every simulation: over the cases the geometric mean of the times, and the
/// largest error; each with its ends.
report::Json data_of(const ThresholdStudy& study);

}  // namespace ricochet::studies::dynamics
