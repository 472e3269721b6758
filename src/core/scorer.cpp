#include "src/core/scorer.h"

#include <cmath>
#include <utility>

namespace ricochet {

Scorer::Scorer(const Problem& problem, std::function<void(const Improvement&)> on_improvement)
    : problem_(problem), on_improvement_(std::move(on_improvement)) {}

void Scorer::score(const Vector& x, const Values* known, std::int64_t evaluations,
                   Stopwatch& clock) {
  TrueValues true_values;
  if (known && !problem_.true_values) {
    true_values = true_values_of(*known, problem_.equalities);
  } else {
    clock.leave_out([&] { true_values = true_values_at(problem_, x); });
  }
  if (std::isnan(true_values.objective) || std::isnan(true_values.violation)) return;
  if (best() && !better(true_values, best()->true_values)) return;
  trace_.push_back({evaluations, clock.read(), true_values, x});
  if (on_improvement_) clock.leave_out([&] { on_improvement_(trace_.back()); });
}

}  // namespace ricochet
