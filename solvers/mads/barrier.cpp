#include "solvers/mads/barrier.h"

#include <algorithm>
#include <cmath>

namespace ricochet {
namespace {

/// Returns true if `a` is no worse than `b` in objective and violation.
bool no_worse(const Trial& a, const Trial& b) {
  return a.objective <= b.objective && a.violation <= b.violation;
}

bool dominates(const Trial& a, const Trial& b) {
  return no_worse(a, b) && !no_worse(b, a);
}

}  // namespace

double violation_of(const Values& values, Eigen::Index equalities) {
  double sum = 0;
  for (Eigen::Index i = 0; i < values.constraints.size(); ++i) {
    const double violation = violation_of(values.constraints[i], i < equalities);
    sum += violation * violation;
  }
  return sum;
}

Progress Barrier::add(const Trial& trial) {
  if (!std::isfinite(trial.objective) || !std::isfinite(trial.violation)) return Progress::none;
  return trial.violation > 0 ? add_infeasible(trial) : add_feasible(trial);
}

Progress Barrier::add_feasible(const Trial& trial) {
  if (!next_feasible_ || trial.objective <= next_feasible_->objective) next_feasible_ = trial;
  const bool beats = !feasible_ || trial.objective < feasible_->objective;
  return beats ? Progress::dominating : Progress::none;
}

Progress Barrier::add_infeasible(const Trial& trial) {
  if (trial.violation > limit_) return Progress::none;
  const auto beats = [&](const Trial& other) { return no_worse(other, trial); };
  if (std::any_of(undominated_.begin(), undominated_.end(), beats)) return Progress::none;
  std::erase_if(undominated_, [&](const Trial& other) { return dominates(trial, other); });
  undominated_.push_back(trial);
  if (!infeasible_) return Progress::none;  // there is no incumbent to beat
  if (dominates(trial, *infeasible_)) return Progress::dominating;
  return trial.violation < infeasible_->violation ? Progress::improving : Progress::none;
}

void Barrier::settle(Progress progress) {
  feasible_ = next_feasible_;
  if (infeasible_) {
    double limit = infeasible_->violation;
    if (progress == Progress::improving) {
      limit = 0;
      for (const Trial& trial : undominated_) {
        if (trial.violation < infeasible_->violation) limit = std::max(limit, trial.violation);
      }
    }
    limit_ = limit;
  }
  std::erase_if(undominated_, [&](const Trial& trial) { return trial.violation > limit_; });
  infeasible_.reset();
  for (const Trial& trial : undominated_) {
    if (!infeasible_ || trial.objective < infeasible_->objective) infeasible_ = trial;
  }
}

}  // namespace ricochet
