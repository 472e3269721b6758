#pragma once

#include <optional>
#include <vector>

#include "ricochet/scene.h"

/// The end of two collisions a turn over restitution and friction: exactly, in the law of throws,
/// and in the formula w = c sqrt((1 - e) / (1 + e)) exp(k mu).
namespace ricochet::studies::long_run {

/// A formula's constants and its errors as ln(formula / border).
struct FormulaWorth {
  double c;  ///< [rad/s]
  double k;
  double rms, worst;     ///< over the machines of all restitutions
  double rms_between;    ///< over those of restitutions between 0.2 and 0.8
  double worst_between;  ///< the largest in size, with its sign
};

struct LawPoint {
  double restitution, friction;
  std::optional<double> border;  ///< [rad/s], exact
  std::optional<double> law;     ///< [rad/s], of throws
};

struct LawComparison {
  std::vector<LawPoint> points;
  double law_rms, law_worst;  ///< of the law of throws, |ln(law / border)|
  double law_worst_struck;    ///< the same where throws cross the clearance just below the border
  FormulaWorth of_paper;      ///< fitted to the paper's ten thresholds
  FormulaWorth of_corners;    ///< fitted to the borders of the paper's four restitutions, frictions
  FormulaWorth of_all;        ///< fitted to all of these borders
};

/// Machines like the given one, undisturbed, with these restitutions and frictions.
LawComparison compared(const carrier_track::Scene& machine, const std::vector<double>& restitutions,
                       const std::vector<double>& frictions);

}  // namespace ricochet::studies::long_run
