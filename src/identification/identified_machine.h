#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/identification/knock_loss.h"
#include "problems/carrier_track/identification/knock_problem.h"
#include "ricochet/solver.h"
#include "src/identification/knock_fit.h"

namespace ricochet::studies::identification {

/// A number with its 95 % interval.
struct Estimate {
  std::string name, unit;
  double value, lower, upper;
  std::optional<double> assumed = {};  ///< the value of the scene's file
};

/// What recorded knocks say of a machine.
struct IdentifiedMachine {
  KnockFit fit;
  carrier_track::Scene scene;       ///< the machine with the fitted constants
  std::vector<Estimate> constants;  ///< restitution, friction, clearance
  std::optional<Estimate> safe_speed;
  Matrix correlations;  ///< 3 x 3, of the constants; NaN where none is known
  /// Otherwise the time limit was reached: no interval is known, and perhaps no safe speed.
  bool complete = true;
  /// Otherwise the fit has not converged, and no interval is known.
  bool has_covariance = true;
  /// What the record contradicts, one sentence each: with any, no interval can be trusted.
  std::vector<std::string> contradictions;
  std::vector<std::string> remarks;  ///< what the record cannot tell, one sentence each
  std::optional<carrier_track::NextSpeed> next;
  std::string next_target;  ///< what the next speed would make more certain

  double explained_share;  ///< of the knocks: those that are not spurious, as fitted
  double missed_share;     ///< of the impacts above the detection limit, as fitted, of both walls
};

/// Returns true if the intervals may be shown.
inline bool is_trusted(const IdentifiedMachine& machine) {
  return machine.complete && machine.has_covariance && machine.contradictions.empty();
}

/// Fits a record. The safe speed and the next one are searched up to `fastest` [rad/s].
IdentifiedMachine identify(const carrier_track::KnockLoss& loss, const Solver& solver,
                           double fastest);

/// The solver that identify() is best called with; see docs/identify.md.
inline constexpr const char* usual_solver = "nlopt-ccsaq";

}  // namespace ricochet::studies::identification
