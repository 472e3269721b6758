#pragma once

#include <string>
#include <vector>

#include "ricochet/verdict.h"

namespace ricochet::comparison {

/// An improvement of a run: a feasible point better than all before it.
struct Step {
  std::int64_t evaluations;  ///< charged until then
  double seconds;
  double optimality_gap;  ///< true objective less the best known
};

/// The termination reason of one start. There are few different ones, so the program keeps one copy
/// of each text.
class Reason {
 public:
  Reason(const std::string& text);  // NOLINT(google-explicit-constructor): it is a text
  Reason(const char* text) : Reason(std::string(text)) {}  // NOLINT(google-explicit-constructor)
  operator const std::string&() const { return *text_; }   // NOLINT(google-explicit-constructor)
  bool operator==(const Reason&) const = default;

 private:
  const std::string* text_;
};

/// One run as scored. Its number among the instances identifies it for a repetition.
struct Outcome {
  int instance = 0;
  Verdict verdict;
  std::int64_t evaluations = 0;  ///< charged in all
  std::int64_t values = 0;       ///< asked for in all
  std::int64_t derivatives = 0;  ///< asked for in all
  double seconds = 0;            ///< processor time in all
  std::vector<Step> steps;
  std::vector<Reason> terminations;  ///< of every start
  std::string failure;               ///< what was thrown; empty if nothing
};

/// The outcome of a record. The problem's best value must be known.
Outcome outcome_of(const RunRecord& record, double best_known, double tolerance);
Outcome outcome_of(const RunRecord& record, const Problem& problem, double tolerance);

}  // namespace ricochet::comparison
