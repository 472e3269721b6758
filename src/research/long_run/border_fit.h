#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ricochet/solver.h"
#include "src/research/paper/throw.h"
#include "src/research/paper/unknown_parameters.h"

/// The interpretation "borders": the threshold is the speed at which a regime of the long run ends.
namespace ricochet::studies::long_run {

/// Which border, of the default interpretation with which parameters fitted.
struct BorderInterpretation {
  std::string name;
  int at_most;                   ///< collisions a turn, even
  carrier_track::Louder louder;  ///< the turns that have more beyond it
  std::vector<carrier_track::Unknown> free;
  bool contact_friction = true;  ///< friction multiplies the walls' own force, too
};

/// The end of silence, of 2 and of 4 a turn, in some turns and in all, with two to five parameters.
std::vector<BorderInterpretation> border_interpretations();

/// The borders of the cases C1..C10 [rad/s], in the law of throws. Nothing where there is none.
std::vector<std::optional<double>> law_borders(const BorderInterpretation& what,
                                               const carrier_track::Constants& constants);

/// The same, exactly: the regimes are walked from the slowest speed to the border.
std::vector<std::optional<double>> exact_borders(const BorderInterpretation& what,
                                                 const carrier_track::Constants& constants);

/// Where a parameter may lie, the others fitted again.
struct ParameterInterval {
  carrier_track::Unknown parameter;
  double value, lower, upper;
  bool lower_open, upper_open;  ///< its bound is reached first
};

/// A combination of parameters, as a direction in their logarithms.
struct Direction {
  std::vector<double> weights;  ///< of unit length, one for each free parameter
  double half_width;            ///< of its 95 % interval, in logarithms; infinite if undetermined
};

struct BorderFit {
  BorderInterpretation what;
  carrier_track::Constants constants;
  std::vector<double> law_errors;  ///< ln(border / paper) of C1..C10, in the law
  std::vector<double> errors;      ///< the same, exactly
  std::vector<double> left_out;    ///< exactly, each from a fit without the case
  std::vector<ParameterInterval> intervals;
  std::vector<Direction> directions;  ///< from the best determined to the worst
};

struct BorderPlan {
  Solver global, least_squares, local;
  std::int64_t evaluations;         ///< of the law, by the global solver; a third by the local one
  std::int64_t polish_evaluations;  ///< of the law, by least squares
};

/// Least squares in the logarithm of the speed, in the law of throws, which costs a thousandth of
/// the exact borders; these judge the fit. Intervals are profile likelihoods in the law, at 95 %,
/// with normal errors of unknown size.
BorderFit fitted(const BorderInterpretation& what, const BorderPlan& plan);

}  // namespace ricochet::studies::long_run
