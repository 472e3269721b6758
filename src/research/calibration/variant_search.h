#pragma once

#include "src/research/calibration/fit_task.h"
#include "src/research/calibration/variants/model_variant.h"

namespace ricochet::studies::calibration {

/// The problem of fitting the parameters of a model variant: the free ones of its base, then its
/// own, each as its place within its bounds, in [0, 1].
Problem variant_problem(const variants::ModelVariant& variant);

/// The constants of a point of that problem.
variants::VariantConstants constants_at(const variants::ModelVariant& variant, const Vector& x);

/// Fits the parameters, starting at start_of(variant): the global solver has two thirds of the
/// evaluations, the local one the rest; returns the best point of all. The result depends only on
/// the search.
Fit fit(const variants::ModelVariant& variant, const Search& search);

/// Returns a task that runs this fit().
FitTask fit_task(const variants::ModelVariant& variant, const Search& search);

/// The parameters of such a fit.
variants::VariantConstants variant_constants(const Fit& fit);

}  // namespace ricochet::studies::calibration
