#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "src/cli/asked_point.h"
#include "src/core/evaluator.h"
#include "src/report/json.h"

namespace ricochet::cli {

/// What there is to say of a point.
struct Answer {
  Derivatives told;     ///< the values alone where no derivatives were asked for
  Residuals residuals;  ///< where they were asked for, their Jacobian only with derivatives
  Truth truth;          ///< what the suite judges by

  /// All its numbers, one after the other.
  std::vector<double> numbers() const;
};

/// With keys for the derivatives and residuals where they were asked for. JSON has no number for
/// what is infinite or no number at all: these are null.
report::Json json_of(const Answer& answer, const AskedPoint& asked);

/// The run of an optimiser outside, which ends when that wants it to.
class OutsideRun {
 public:
  explicit OutsideRun(Problem problem);
  OutsideRun(const OutsideRun&) = delete;
  OutsideRun& operator=(const OutsideRun&) = delete;

  const Problem& problem() const { return problem_; }

  /// Throws what the problem throws; the run goes on all the same.
  Answer answer(const AskedPoint& asked);

  /// So many as a solver would have been charged.
  std::int64_t evaluations() { return before_ + evaluator_->ledger().charged; }

 private:
  Problem problem_;          // whose truth is remembered as it is computed
  Truth truth_;              // of the point asked for last, where it is not what is shown
  std::int64_t before_ = 0;  // evaluations until the problem threw last
  std::optional<Evaluator> evaluator_;  // a new one after that
};

}  // namespace ricochet::cli
