#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/research/calibration/appraisal.h"
#include "src/research/calibration/variant_search.h"

/// The interpretation "long run": the paper's count is that of a window of the long run, a number
/// of turns times the mean collisions a turn, rounded. The start has no effect.
namespace ricochet::studies::long_run {

/// The purity that counts as reached.
inline constexpr double purity_goal = 0.9;

/// What a search minimises.
enum class Goal {
  loss,   ///< the loss of every interpretation
  purity  ///< the same, with a purity of 90 % in every case first
};

/// A model variant whose count is that of the long run, and how it is fitted.
struct CountInterpretation {
  variants::ModelVariant variant;
  Goal goal = Goal::loss;
};

/// With the turns of the window fitted; with normal force and pull fitted, too; with one turn; with
/// a purity of 90 % first; and with friction that does not multiply the walls' force.
std::vector<CountInterpretation> count_interpretations();

struct CountFit {
  CountInterpretation what;
  calibration::Fit fit;
  double loss;  ///< without the goal's part
  calibration::Appraisal appraisal;
  std::vector<double> left_out;  ///< ln(threshold / paper) of each case, from a fit without it
};

struct CountPlan {
  calibration::Search search;
  std::int64_t left_out_evaluations;  ///< of the local solver, from the fit
  double step;                        ///< [rad/s] between the speeds of an evaluation
};

/// C1..C10.
std::vector<carrier_track::Case> cases_with_threshold();

/// ln(threshold / paper) of an evaluated case with a claim; without a threshold, as if it were at
/// the nearer end of the range.
double error_of(const calibration::CaseAppraisal& judged);

/// The fit of an interpretation, evaluated with exact counts.
CountFit fitted(const CountInterpretation& what, const CountPlan& plan);

}  // namespace ricochet::studies::long_run
