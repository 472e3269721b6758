#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "problems/own/evaluation_store.h"
#include "problems/own/problem_file.h"
#include "ricochet/problem.h"

namespace ricochet::own {

/// What became of a problem's evaluations since it was opened, in this process and those forked
/// from it.
struct EvaluationCounts {
  std::int64_t computed = 0;  ///< by the program
  std::int64_t found = 0;     ///< in the store
  std::int64_t failed = 0;    ///< of both
  double seconds = 0;         ///< that the program took for both, now or then
  std::int64_t asked = 0;     ///< number of the point that a run waits for, last; 0: none does

  EvaluationCounts& operator+=(const EvaluationCounts& other) {
    computed += other.computed;
    found += other.found;
    failed += other.failed;
    seconds += other.seconds;
    return *this;
  }
};

/// A problem of a user's own, with its program and its store of evaluations.
///
/// What a solver sees: logarithmic variables are their natural logarithms; an objective to maximise
/// is negated; equalities come first; a binary constraint is -1 where it holds and 1 where it does
/// not; all values of an evaluation that failed are NaN. Residuals without derivatives get forward
/// differences, each of which is an evaluation of the program.
class OwnProblem {
 public:
  /// `run` names who asks, for the evaluations of a noisy problem. Starts nothing yet. Throws
  /// InputError for a file, a program or a store that cannot be used.
  explicit OwnProblem(ProblemFile file, std::string run = "");

  /// The same problem, with the same program and store, for another run: with counts of its own.
  OwnProblem of_run(std::string run) const;

  /// Works as long as this object or a copy of the problem lives.
  const Problem& problem() const { return problem_; }
  const ProblemFile& file() const;

  /// The program, for people.
  std::string command() const;
  std::filesystem::path store_path() const;
  EvaluationStore& store() const;
  EvaluationCounts counts() const;

  /// Evaluates once more at a point in the file's coordinates, whatever the store has. Kept unless
  /// values are noisy or it was kept before.
  Given evaluate_again(const Vector& stated) const;

 private:
  struct Shared;
  explicit OwnProblem(std::shared_ptr<Shared> shared);

  std::shared_ptr<Shared> shared_;
  Problem problem_;
};

/// The store's file: that of the problem with the ending .evaluations.
std::filesystem::path store_of(const std::filesystem::path& problem_file);

}  // namespace ricochet::own
