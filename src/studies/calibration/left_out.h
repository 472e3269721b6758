#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/core/fields.h"
#include "src/studies/calibration/searches.h"

/// Does a fit predict what was left out of it? The paper's ten cases are four machines: those of
/// one machine differ in the disturbance alone. So a case is independent of the fit only if its
/// whole machine is left out; leaving out a level of restitution or of friction also asks whether
/// the fit extrapolates.
namespace ricochet::studies::calibration {

/// What is left out of a fit together.
enum class LeftOut { nothing, one_case, machine, restitution, friction };

inline constexpr LeftOut all_left_out[] = {LeftOut::nothing, LeftOut::one_case, LeftOut::machine,
                                           LeftOut::restitution, LeftOut::friction};

/// In words: "without its machine".
const EnumNames<LeftOut>& names_of(LeftOut what);

/// The groups of cases that are left out in turn: none; each of C1..C10; those of each pair of
/// restitution and friction; of each restitution; of each friction. With a machine goes its claim
/// on C11, too.
std::vector<carrier_track::CaseIds> groups_of(LeftOut what);

/// The threshold of a case, from a fit to what was not left out with it.
struct Prediction {
  LeftOut what;
  std::string case_id;
  double paper;                     ///< [rad/s]
  std::optional<double> predicted;  ///< [rad/s]

  /// ln(predicted / paper); a missing prediction counts as ln 2.
  double error() const;
};

/// The thresholds of `choice`, and those of fits of its free parameters without each group of each
/// kind. These begin at the natural values, which know nothing of the choice: the best of `times`
/// searches with seeds from search.seed on. Thresholds are from speeds `step` [rad/s] apart.
std::vector<Prediction> predictions(const Fit& choice, Search search, int times, double step,
                                    Searches& searches);

/// Those of a kind.
std::vector<Prediction> predictions_without(LeftOut what, const std::vector<Prediction>& all);

/// Their errors.
std::vector<double> errors_of(const std::vector<Prediction>& predictions);

/// Their errors, those of a machine together.
std::vector<std::vector<double>> errors_by_machine(const std::vector<Prediction>& predictions);

}  // namespace ricochet::studies::calibration
