#pragma once

#include <string>
#include <vector>

#include "ricochet/families.h"
#include "ricochet/problem.h"
#include "src/research/paper/fitted_interpretation.h"
#include "src/research/paper/unknown_parameters.h"

namespace ricochet::carrier_track::inline paper {

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
Problem calibration_problem(const Parameterisation& parameterisation,
                            const std::string& left_out = "");

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
