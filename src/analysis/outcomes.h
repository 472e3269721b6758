#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/analysis/statistics/ranking.h"
#include "src/experiment/store.h"

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
  std::optional<TrueValues> returned = {};  ///< of the returned point, feasible or not
  std::int64_t evaluations = 0;             ///< charged in all
  std::int64_t values = 0;                  ///< asked for in all
  std::int64_t derivatives = 0;             ///< asked for in all
  double seconds = 0;                       ///< processor time in all
  std::vector<Step> steps;                  ///< of the best evaluated point
  std::vector<Reason> terminations;         ///< of every start
  std::string failure;                      ///< what was thrown; empty if nothing

  bool solved(Criterion criterion = Criterion::returned) const {
    return criterion == Criterion::returned ? verdict.returned_solved : verdict.solved;
  }
  /// The optimality gap of the returned point; infinite if it is not feasible.
  double optimality_gap() const;
};

/// The optimality gap of the returned point, >= 0; of an infeasible one what it exceeds the best
/// value by, if it does, and the problem's penalty weight times its violation. Infinite without a
/// point.
double merit_gap(const Problem& problem, const Outcome& outcome);

/// The improvements that led to the returned point: those of the best evaluated one as far as the
/// first that is as good as the returned one, whose optimality gap the last step has. A run that
/// returned a feasible point without evaluating one as good has a step at its end. Empty if there
/// is no feasible point.
std::vector<Step> steps_of(const Outcome& outcome);

/// Charged evaluations until a point that solves the problem was evaluated if the point that is
/// judged solves it; otherwise all of the run.
std::int64_t evaluations_until_solved(const Outcome& outcome,
                                      Criterion criterion = Criterion::returned);
/// The same in seconds of processor time, of the returned point.
double seconds_until_solved(const Outcome& outcome);

/// The outcome of a record. The problem's best value must be known.
Outcome outcome_of(const RunRecord& record, double best_known, double tolerance);
Outcome outcome_of(const RunRecord& record, const Problem& problem, double tolerance);

/// The runs of a cell, or every k-th of them. They do not change, and copies share them, so that
/// many selections of a million runs need one copy only.
class Outcomes {
 public:
  class Iterator {
   public:
    Iterator(const Outcomes& outcomes, std::size_t place) : outcomes_(outcomes), place_(place) {}
    const Outcome& operator*() const { return outcomes_[place_]; }
    Iterator& operator++() { return ++place_, *this; }
    bool operator!=(const Iterator& other) const { return place_ != other.place_; }

   private:
    const Outcomes& outcomes_;
    std::size_t place_;
  };

  Outcomes() = default;
  Outcomes(std::vector<Outcome> all)  // NOLINT(google-explicit-constructor): it is nothing else
      : all_(std::make_shared<const std::vector<Outcome>>(std::move(all))), size_(all_->size()) {}
  Outcomes(std::initializer_list<Outcome> all) : Outcomes(std::vector<Outcome>(all)) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Outcome& operator[](std::size_t i) const { return (*all_)[first_ + i * step_]; }
  const Outcome& front() const { return (*this)[0]; }
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size_}; }

  /// `size` of them: the one at `first` and every `step`-th after it; all must exist.
  Outcomes every(std::size_t step, std::size_t first, std::size_t size) const {
    Outcomes part = *this;
    part.first_ = first_ + first * step_;
    part.step_ = step_ * step;
    part.size_ = size;
    return part;
  }

 private:
  std::shared_ptr<const std::vector<Outcome>> all_;
  std::size_t first_ = 0, step_ = 1, size_ = 0;
};

/// A run of a store with its outcome.
struct JudgedRun {
  const StoredProblem& problem;
  const StoredRun& stored;
  const Outcome& outcome;
};

/// All runs that differ only in instance and number.
struct JudgedCell {
  const Cell& cell;
  const StoredProblem& problem;
  Outcomes outcomes;  ///< at least one
};

/// Passes every run of the store to `use`, cell by cell, and every cell to `at_end` after its last
/// run. Keeps only the runs of one cell in memory. Throws InputError if the store is damaged.
void each_judged(const Store& store, const std::function<void(const JudgedRun&)>& use,
                 const std::function<void(const JudgedCell&)>& at_end);

/// What a run is ranked by: the optimality gap of the returned point, 0 for all that solve
/// the problem, as accuracy beyond the tolerance does not count; then the evaluations until a point
/// as good was first evaluated. Infinite without a feasible point.
Reached reached_by(const Outcome& outcome);

// Patterns are shell patterns separated by commas: see names.h.

/// The problems whose names match and whose best values are known. Throws InputError, naming
/// `option`, if there is none.
std::vector<Problem> chosen_problems(const std::vector<Problem>& all, const std::string& patterns,
                                     const std::string& option);

/// The solvers whose names match. Throws InputError if there is none.
std::vector<Solver> chosen_solvers(const std::vector<Solver>& all, const std::string& patterns,
                                   const std::string& option);

/// The optimality gaps that are the targets of a problem, rising: the first is its tolerance, with
/// which it is solved.
using Targets = std::vector<double>;

/// The optimality gap of a point that costs no search: the median of the true objective at 15
/// random points of the box, the same ones for every solver, less the best known value. Infeasible
/// points count only if all are infeasible; then the size of the gap is taken. Points where the
/// problem throws or is not finite do not count; without any other the result is 0.
double reference_gap(const Problem& problem);

/// The targets between the best known value, which the problem must have, and the reference gap. Of
/// a count, whose tolerance is 1/2, all integer levels: gaps of 1/2, 3/2, ... Otherwise 51 gaps,
/// evenly spaced on a logarithmic scale. The tolerance alone if the reference gap is within it.
Targets targets_of(const Problem& problem);

}  // namespace ricochet::comparison
