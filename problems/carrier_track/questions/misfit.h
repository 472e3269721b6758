#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problems/carrier_track/paper/open_constants.h"
#include "src/core/vector.h"

/// How far a reading and its constants are from what the paper claims: the six parts of the score
/// (threshold.h) of every case, looked at more coarsely than a judgement does, as one number.
namespace ricochet::carrier_track::inline questions {

/// A speed, and the stretch of speeds that it stands for, so that slow thresholds are seen as
/// finely as fast ones and shares are still those of evenly spaced speeds.
struct SpeedCell {
  double omega;  ///< [rad/s]
  double width;  ///< [rad/s]
};

/// The whole of 0..18 rad/s, in cells of a sixteenth of a threshold [rad/s] up to 1.3 times it
/// and of about 0.6 rad/s beyond.
std::vector<SpeedCell> speed_cells(double threshold);

/// Counts beyond this are taken for one more than this.
inline constexpr int most_counted = 100;

/// The six parts for one case, from coarse cells.
struct CoarseScore {
  int quiet_count;       ///< (1)
  double purity;         ///< (2)
  double threshold;      ///< (3) [rad/s]; the nearest end of the range where there is none
  double misclassified;  ///< (4)
  double loudness;       ///< (5)
  int wrong_examples;    ///< (6) 0, 1 or 2
  double shape;          ///< mean distance, in ln(count), of a speed from what the claim says of it
};

/// What part of the misfit a case adds. Each part of the score counts as its distance from the
/// claim over a tolerance, and from three tolerances on by its logarithm alone, so that one
/// hopeless case leaves the others their say:
///   count |ln((q + 0.3) / (paper + 0.3))| / 0.15, purity below 0.9 / 0.15,
///   threshold |ln| / 0.05, misclassified above 0.02 / 0.05, loudness ln(1.5 / l) / 0.2,
///   and 2 for each wrong example.
/// To them come 3 shapes, which tell a search the way where the others are flat.
double misfit_of(const CoarseScore& score, const Claim& claim);

/// The same, part by part, in the order in which they are added.
struct MisfitParts {
  double count, purity, threshold, misclassified, loudness, examples, shape;
};
MisfitParts misfit_parts(const CoarseScore& score, const Claim& claim);

/// The counts of a case at some speeds [rad/s], or most_counted + 1 where they are higher.
using CountsOf = std::function<std::vector<int>(const Case&, const std::vector<double>& speeds)>;

/// With `finer` above 1 the two cells next to the threshold are looked at again in so many parts
/// each: the threshold is then known to that part of a cell.
CoarseScore coarse_score(const CountsOf& counts, const Case& a_case, int finer = 1);
CoarseScore coarse_score(const Reading& reading, const Constants& constants, const Case& a_case,
                         int finer = 1);

/// The share of 0..18 rad/s at which C11, of which the paper says that it is never quiet, has a
/// count that is quiet where `quiet` is C4's quiet count.
double quiet_share_of_c11(const CountsOf& counts, int quiet);
double quiet_share_of_c11(const Reading& reading, const Constants& constants, int quiet);

/// The sum over C1..C10, and 4 times the share of speeds at which C11, of which the paper says that
/// it is never quiet, has a count that is quiet in C4. A case may be left out.
double misfit(const CountsOf& counts, const std::string& left_out = "");
double misfit(const Reading& reading, const Constants& constants, const std::string& left_out = "");

/// The smooth stand-in, for least squares: with surrogate counts s of `width` in place of counts,
/// ln((s + 0.5) / (quiet + 0.5)) at every cell below the paper's threshold and
/// max(0, ln(1.6 quiet / (s + 0.5))) above, each times the root of its cell's share of its side.
struct SmoothMisfit {
  Vector residuals;
  Matrix slopes;  ///< residuals x freed, with respect to the constants themselves
};

/// Exact derivatives, but for the window, the crossing and the contact speed, whose columns are 0:
/// they have no derivative everywhere, or the model of theirs none.
SmoothMisfit smooth_misfit(const Reading& reading, const Constants& constants,
                           const std::vector<Open>& freed, double width);

}  // namespace ricochet::carrier_track::inline questions
