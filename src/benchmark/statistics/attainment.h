#pragma once

#include <vector>

namespace ricochet {

/// The best value so far is `value` from the evaluation `evaluations` >= 1 on.
struct BestSoFar {
  double evaluations, value;
};

/// The improvements of a run: evaluations rise, values fall. None where it found nothing.
using History = std::vector<BestSoFar>;

/// Throws std::invalid_argument for a history that is not as said.
void check_history(const History& history);

/// The best and the worst value that count, lower < upper: fixed before the runs, not taken from
/// them.
struct Levels {
  double lower, upper;
};

/// How far a run has come by its evaluation t: (upper - b) / (upper - lower), where b is the best
/// value so far, no more than upper and no less than lower. With integer values it is the share of
/// all levels lower, lower + 1, ..., upper - 1 that b has reached, so that no targets need be
/// chosen (Grunert da Fonseca, Fonseca and Hall 2001, doi:10.1007/3-540-44719-9_15; López-Ibáñez et
/// al. 2024, doi:10.1109/TEVC.2024.3462758). 0 before the first improvement. Throws
/// std::invalid_argument for levels or a history that are not as said.
double attainment(const History& history, const Levels& levels, double t);

enum class EvaluationAxis { linear, logarithmic };

/// Area over the convergence curve, in [0, 1]: the mean of the attainment over the evaluations 1 to
/// `budget` >= 1. Each counts the same, or evaluation i as log((i + 1) / i), which is its length on
/// a logarithmic axis. Throws std::invalid_argument as above, or for a smaller budget.
double area_over_convergence_curve(const History& history, const Levels& levels, double budget,
                                   EvaluationAxis axis);

}  // namespace ricochet
