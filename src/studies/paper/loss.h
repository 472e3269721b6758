#pragma once

#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "src/studies/paper/interpretation.h"

/// The loss: how far an interpretation with its parameters is from the paper's claims. It combines
/// the six parts of the score (threshold.h) of every case, on a coarser grid than an evaluation, in
/// one number.
namespace ricochet::carrier_track::inline paper {

/// A speed, and the width of the range that it represents, so that slow thresholds are resolved as
/// finely as fast ones and shares are those of evenly spaced speeds.
struct SpeedCell {
  double omega;  ///< [rad/s]
  double width;  ///< [rad/s]
};

/// The whole of 0..18 rad/s, in cells of a sixteenth of a threshold [rad/s] up to 1.3 times it
/// and of about 0.6 rad/s beyond.
std::vector<SpeedCell> speed_cells(double threshold);

/// Higher counts are taken as one more than this.
inline constexpr int most_counted = 100;

/// The counts of a case at some speeds [rad/s], or most_counted + 1 where they are higher.
std::vector<int> counts_of(const Parameterisation& fit, const Case& a_case,
                           const std::vector<double>& speeds);

/// The same without a highest count, and of carriers that rest as late as in every other command.
std::vector<int> exact_counts(const Parameterisation& fit, const Case& a_case,
                              const std::vector<double>& speeds);

/// The six parts for one case, from coarse cells.
struct CoarseScore {
  int quiet_count;       ///< (1)
  double purity;         ///< (2)
  double threshold;      ///< (3) [rad/s]; the nearest end of the range if there is none
  double misclassified;  ///< (4)
  double loudness;       ///< (5)
  int wrong_examples;    ///< (6) 0, 1 or 2
  double shape;          ///< mean distance of a speed from its claim, in ln(count)
};
CoarseScore coarse_score(const Parameterisation& fit, const Case& a_case);

/// The contribution of a case to the loss. Each part of the score counts as its distance from the
/// claim over a tolerance, and beyond three tolerances logarithmically, so that one hopeless case
/// does not dominate the others:
/// count |ln((q + 0.3) / (paper + 0.3))| / 0.15, purity below 0.9 / 0.15,
/// threshold |ln| / 0.05, misclassified above 0.02 / 0.05, loudness ln(1.5 / l) / 0.2,
/// and 2 for each wrong example.
/// 3 shapes are added, which guide the search where the other parts are flat.
double loss_of(const CoarseScore& score, const Claim& claim);

/// The share of 0..18 rad/s at which C11, which according to the paper is never quiet, has a count
/// that is quiet if `quiet` is C4's quiet count.
double quiet_share_of_c11(const Parameterisation& fit, int quiet);

/// Ids of cases, of C1..C11.
using CaseIds = std::vector<std::string>;

/// The sum over C1..C10, and 4 times the share of speeds at which C11, which according to the paper
/// is never quiet, has a count that is quiet in C4. Cases may be left out.
double loss(const Parameterisation& fit, const CaseIds& left_out = {});

/// The smooth loss, for least squares: with surrogate counts s of `smoothing` instead of counts,
/// ln((s + 0.5) / (quiet + 0.5)) at every cell below the paper's threshold and max(0, ln(1.6 quiet
/// / (s + 0.5))) above, each times the square root of its cell's share of its side. Cases may be
/// left out.
struct SmoothLoss {
  Vector residuals;
  Matrix slopes;  ///< residuals x free, with respect to the parameters themselves
};

/// Exact derivatives, except that the columns of the window, the crossing and the contact speed are
/// 0: they are not differentiable everywhere, or their model has no derivatives.
SmoothLoss smooth_loss(const Parameterisation& fit, double smoothing, const CaseIds& left_out = {});

/// The same fit with its free parameters reset to their natural values.
Parameterisation forgotten(Parameterisation fit);

/// The problem of fitting the unknown parameters: minimise the loss over the free ones, each as its
/// place within its bounds, in [0, 1]. Its residuals are those of the smooth loss of
/// `default_smoothing`; its true objective is the loss. It starts from the values given.
Problem calibration_problem(const Parameterisation& start, const CaseIds& left_out = {});

/// The calibration of an interpretation: the parameters that were fitted start at their natural
/// values, the others are fixed as in the interpretation.
Problem calibration_problem(const FittedInterpretation& fitted);

/// The calibration of the default interpretation, as a family of one problem.
Family calibration_family();

/// The fit at a point of its problem.
Parameterisation fit_at(Parameterisation fit, const Vector& x);

/// The point of its problem that a fit is, if its free parameters lie within the bounds.
Vector point_of(const Parameterisation& fit);

}  // namespace ricochet::carrier_track::inline paper
