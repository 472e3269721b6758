#pragma once

#include <cstdint>
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

/// What of a run is judged: the point that it returned, which is what a user gets, or the best
/// point that it evaluated, which a solver that saw a surrogate could not tell from others.
enum class Criterion { returned, evaluated };

/// One run as scored. Its number among the instances identifies it for a repetition.
struct Outcome {
  int instance = 0;
  Verdict verdict;
  std::int64_t evaluations = 0;      ///< charged in all
  std::int64_t values = 0;           ///< asked for in all
  std::int64_t derivatives = 0;      ///< asked for in all
  double seconds = 0;                ///< processor time in all
  std::vector<Step> steps;           ///< of the best evaluated point
  std::vector<Reason> terminations;  ///< of every start
  std::string failure;               ///< what was thrown; empty if nothing

  bool solved(Criterion criterion = Criterion::returned) const {
    return criterion == Criterion::returned ? verdict.returned_solved : verdict.solved;
  }
  /// The optimality gap of the point that is judged; infinite if there is no feasible one.
  double optimality_gap(Criterion criterion = Criterion::returned) const;
};

/// The improvements that led to the point that is judged. Of a returned point: those of the best
/// evaluated one as far as the first that is as good as the returned one, whose optimality gap the
/// last step has. A run that returned a feasible point without evaluating one as good has a step at
/// its end. Empty if there is no feasible point.
std::vector<Step> steps_of(const Outcome& outcome, Criterion criterion = Criterion::returned);

/// Charged evaluations until a point that solves the problem was evaluated if the point that is
/// judged solves it; otherwise all of the run.
std::int64_t evaluations_until_solved(const Outcome& outcome,
                                      Criterion criterion = Criterion::returned);
/// The same in seconds of processor time.
double seconds_until_solved(const Outcome& outcome, Criterion criterion = Criterion::returned);

/// The outcome of a record. The problem's best value must be known.
Outcome outcome_of(const RunRecord& record, double best_known, double tolerance);
Outcome outcome_of(const RunRecord& record, const Problem& problem, double tolerance);

}  // namespace ricochet::comparison
