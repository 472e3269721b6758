#pragma once

#include <string>
#include <vector>

#include "src/core/verdict.h"

namespace ricochet::contest {

/// When a run found something feasible and better than all before it.
struct Step {
  std::int64_t evaluations;  ///< charged until then
  double seconds;
  double regret;  ///< true objective less the best known
};

/// What a solver said at the end of a start. Solvers say few things often: of equal texts the
/// program has one copy, which it keeps.
class Reason {
 public:
  Reason(const std::string& text);  // NOLINT(google-explicit-constructor): it is a text
  Reason(const char* text) : Reason(std::string(text)) {}  // NOLINT(google-explicit-constructor)
  operator const std::string&() const { return *text_; }   // NOLINT(google-explicit-constructor)
  bool operator==(const Reason&) const = default;

 private:
  const std::string* text_;
};

/// One run as it is judged; what it takes to run it again is its number among the instances.
struct Outcome {
  int instance = 0;
  Verdict verdict;
  std::int64_t evaluations = 0;  ///< charged in all
  std::int64_t values = 0;       ///< asked for in all
  std::int64_t derivatives = 0;  ///< asked for in all
  double seconds = 0;            ///< processor time in all
  std::vector<Step> steps;
  std::vector<Reason> exits;  ///< of every start
  std::string failure;        ///< what was thrown; empty if nothing
};

/// Judges a record. The problem's best value must be known.
Outcome outcome_of(const RunRecord& record, double best_known, double tolerance);
Outcome outcome_of(const RunRecord& record, const Problem& problem, double tolerance);

}  // namespace ricochet::contest
