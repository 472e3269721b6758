#pragma once

#include <vector>

#include "problems/classic/formula.h"
#include "ricochet/problem.h"

/// Five families of the literature that are held out: the rule of the solver "auto" was written
/// before anybody saw a run on them, and is measured on them. Patterns choose them only by name;
/// see Problem::held_out.
namespace ricochet::held_out {

/// "outside-global", "outside-smooth", "outside-constrained", "outside-fit" and "outside-rough".
std::vector<Family> families();

/// Functions with several valleys, with gradients.
std::vector<Problem> global_problems();
/// Functions without constraints, of 4 to 20 variables, with gradients.
std::vector<Problem> smooth_problems();
/// Design problems and problems of the CEC 2006 competition, with gradients.
std::vector<Problem> constrained_problems();
/// Regressions with certified results, and parameters of differential equations, with residuals.
std::vector<Problem> fit_problems();
/// Functions with kinks, values that jump, and simulated systems; without gradients.
std::vector<Problem> rough_problems();

/// A statement whose name begins with the family's. Without a start it begins in the middle of the
/// box.
classic::Statement stated(const char* family, const char* name, const char* source, Vector lower,
                          Vector upper, Vector start, double best_known, Vector best_point,
                          const char* provenance);

}  // namespace ricochet::held_out
