#pragma once

#include <functional>
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

/// What the paper claims of a threshold, as goals of a case's score (threshold.h): nearly all
/// speeds below it have the quiet count, hardly any lies on the wrong side, and it is clearly
/// louder above.
inline constexpr double least_purity = 0.9, most_misclassified = 0.02, least_loudness = 1.5;

/// Higher counts are taken as one more than this.
inline constexpr int most_counted = 100;

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

/// The contribution of a case to the loss. Each part of the score counts as its distance from the
/// claim over a tolerance, and beyond three tolerances logarithmically, so that one hopeless case
/// does not dominate the others:
/// count |ln((q + 0.3) / (paper + 0.3))| / 0.15, purity below 0.9 / 0.15,
/// threshold |ln| / 0.05, misclassified above 0.02 / 0.05, loudness ln(1.5 / l) / 0.2,
/// and 2 for each wrong example.
/// 3 shapes are added, which guide the search where the other parts are flat.
double loss_of(const CoarseScore& score, const Claim& claim);

/// The same, part by part, in the order in which they are added.
struct LossParts {
  double count, purity, threshold, misclassified, loudness, examples, shape;
};
LossParts loss_parts(const CoarseScore& score, const Claim& claim);

/// The counts of a case at some speeds [rad/s], or most_counted + 1 where they are higher.
using CountsOf = std::function<std::vector<int>(const Case&, const std::vector<double>& speeds)>;

/// If `finer` is above 1, the two cells next to the threshold are divided into this number of
/// parts: the threshold is then known to that part of a cell.
CoarseScore coarse_score(const CountsOf& counts, const Case& a_case, int finer = 1);
CoarseScore coarse_score(const Interpretation& interpretation, const Constants& constants,
                         const Case& a_case, int finer = 1);

/// The share of 0..18 rad/s at which C11, which according to the paper is never quiet, has a count
/// that is quiet if `quiet` is C4's quiet count.
double quiet_share_of_c11(const CountsOf& counts, int quiet);
double quiet_share_of_c11(const Interpretation& interpretation, const Constants& constants,
                          int quiet);

/// Ids of cases, of C1..C11.
using CaseIds = std::vector<std::string>;

/// The sum over C1..C10, and 4 times the share of speeds at which C11, which according to the paper
/// is never quiet, has a count that is quiet in C4. Cases may be left out.
double loss(const CountsOf& counts, const CaseIds& left_out = {});
double loss(const Interpretation& interpretation, const Constants& constants,
            const CaseIds& left_out = {});

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
SmoothLoss smooth_loss(const Interpretation& interpretation, const Constants& constants,
                       const std::vector<Unknown>& free, double smoothing,
                       const CaseIds& left_out = {});

/// The free parameters of a fit; `held` has their start values and the values of the fixed ones.
struct Parameterisation {
  Interpretation interpretation;
  std::vector<Unknown> free;
  Constants held;
};

/// All parameters that the interpretation uses are free.
Parameterisation full_parameterisation(const Interpretation& interpretation);

/// The same free parameters as in a fit, reset to their natural values; the others as fixed there.
Parameterisation forgotten(const Interpretation& interpretation, const std::vector<Unknown>& free,
                           const Constants& constants);

/// The problem of fitting the unknown parameters: minimise the loss over the free ones, each as its
/// place within its bounds, in [0, 1]. Its residuals are those of the smooth loss of
/// `default_smoothing`; its true objective is the loss. It starts from the values in `held`.
Problem calibration_problem(const Parameterisation& parameterisation, const CaseIds& left_out = {});

/// The calibration of an interpretation: the parameters that were fitted start at their natural
/// values, the others are fixed as in the interpretation.
Problem calibration_problem(const FittedInterpretation& fitted);

/// The calibration of the default interpretation, as a family of one problem.
Family calibration_family();

/// The parameters at a point of that problem.
Constants constants_at(const Parameterisation& parameterisation, const Vector& x);

/// The point of that problem for these parameters, if they lie within the bounds.
Vector point_of(const Parameterisation& parameterisation, const Constants& constants);

}  // namespace ricochet::carrier_track::inline paper
