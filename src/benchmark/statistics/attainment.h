#pragma once

#include <vector>

namespace ricochet {

/// The best value so far is `value` from the evaluation `evaluations` >= 1 on.
struct BestSoFar {
  double evaluations, value;
};

/// The improvements of a run: evaluations rise, values fall. Empty if the run found nothing.
using History = std::vector<BestSoFar>;

/// Throws std::invalid_argument for a history that breaks these rules.
void check_history(const History& history);

/// The best and the worst value that count, lower < upper. Fixed before the runs, not taken from
/// them.
struct Levels {
  double lower, upper;
};

/// Attainment of a run at its evaluation t: (upper - b) / (upper - lower), where b is the best
/// value so far, clamped to [lower, upper]; 0 before the first improvement. For integer values it
/// is the share of the levels lower, lower + 1, ..., upper - 1 that b has reached, so that no
/// targets need be chosen (Grunert da Fonseca, Fonseca and Hall 2001, doi:10.1007/3-540-44719-9_15;
/// López-Ibáñez et al. 2024, doi:10.1109/TEVC.2024.3462758). Throws std::invalid_argument for
/// invalid levels or an invalid history.
double attainment(const History& history, const Levels& levels, double t);

enum class EvaluationAxis { linear, logarithmic };

/// Area over the convergence curve, in [0, 1]: the mean of the attainment over the evaluations 1 to
/// `budget` >= 1. On a linear axis each evaluation has the same weight; on a logarithmic axis
/// evaluation i has the weight log((i + 1) / i). Throws std::invalid_argument as above, or for a
/// smaller budget.
double area_over_convergence_curve(const History& history, const Levels& levels, double budget,
                                   EvaluationAxis axis);

}  // namespace ricochet
