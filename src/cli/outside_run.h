#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ricochet/evaluator.h"
#include "solvers/outside/asked_points.h"
#include "src/report/json.h"

namespace ricochet::cli {

/// The values at a point.
struct Answer {
  Derivatives told;        ///< only the values if no derivatives were requested
  Residuals residuals;     ///< if requested; with their Jacobian only if derivatives were requested
  TrueValues true_values;  ///< the suite scores by these

  /// Returns all its numbers as one list.
  std::vector<double> numbers() const;
};

/// Has keys for derivatives and residuals if they were requested. JSON has no infinity and no NaN:
/// these are null.
report::Json json_of(const Answer& answer, outside::Wanted wanted);

/// A run of an external optimiser, which ends when the optimiser decides so.
class OutsideRun {
 public:
  explicit OutsideRun(Problem problem);
  OutsideRun(const OutsideRun&) = delete;
  OutsideRun& operator=(const OutsideRun&) = delete;

  const Problem& problem() const { return problem_; }

  /// Throws what the problem throws; the run continues.
  Answer answer(const Vector& x, outside::Wanted wanted);

  /// The number of evaluations that a solver would have been charged.
  std::int64_t evaluations() { return before_ + evaluator_->ledger().charged; }

 private:
  Problem problem_;
  std::int64_t before_ = 0;             // evaluations until the problem last threw
  std::optional<Evaluator> evaluator_;  // renewed after that
};

}  // namespace ricochet::cli
