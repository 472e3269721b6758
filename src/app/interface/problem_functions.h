#pragma once

#include <fmt/format.h>
#include <ricochet/ricochet.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>

#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "ricochet/random.h"
#include "src/app/interface/interface.h"
#include "src/core/seen_problem.h"

namespace ricochet::interface {

/// A problem, and the run that evaluates it.
struct OpenedRun {
  OpenedRun(Problem asked, std::int64_t budget, std::uint64_t seed)
      : problem(std::move(asked)), evaluator(problem, Budget{budget}), random(seed) {}

  Problem problem;
  Evaluator evaluator;
  Random random;
};

/// A problem opened by an external program. After every refused call, last_error() gives the
/// reason. Several threads may call its functions at once: they take turns.
class OpenedProblem : private OpenedRun, public SeenProblem {
 public:
  /// `budget`: evaluations; `seed`: for uniform().
  OpenedProblem(Problem asked, std::int64_t budget, std::uint64_t seed);

  /// The true objective and violation of x, or of its projection onto the box; not charged. Throws
  /// std::invalid_argument for null or a point that is not finite, and what the problem throws.
  TrueValues judge(const double* x) const;

  /// In its formulation and instance.
  const Problem& stated() const { return problem; }

 private:
  /// The function of SeenProblem of this signature, in turn; where it returns `refused` it keeps
  /// the reason as the last error.
  template <auto function, auto refused>
  struct InTurn;

  /// Why the last call was refused.
  std::exception_ptr reason() const;

  std::int64_t budget_;
  mutable std::mutex mutex_;
};

/// What an external program holds open. `Opened` is derived from the `Handle` that the program
/// sees; a pointer that is not one of those given is detected.
template <class Handle, class Opened>
class OpenHandles {
 public:
  /// `noun`: what is open, for messages.
  explicit OpenHandles(std::string noun) : noun_(std::move(noun)) {}

  Handle* add(std::unique_ptr<Opened> opened) {
    Handle* const handle = opened.get();
    const std::lock_guard lock(mutex_);
    opened_.emplace(handle, std::move(opened));
    return handle;
  }

  /// What is open, which stays so while the result is kept, also if another thread closes it.
  /// Throws InputError if it is not open.
  std::shared_ptr<Opened> at(const Handle* handle) {
    const std::lock_guard lock(mutex_);
    return found(handle)->second;
  }

  /// What `asked` returns for what is open, or `refused`, with the last error, if it is not open or
  /// `asked` throws.
  template <class Result, class Asked>
  Result ask(const Handle* handle, Result refused, const Asked& asked) {
    Result result = refused;
    succeeds([&] {
      const std::shared_ptr<Opened> opened = at(handle);
      result = asked(*opened);
    });
    return result;
  }

  /// Throws InputError if it is not open.
  void close(const Handle* handle) {
    std::shared_ptr<Opened> closed;  // destroyed after the lock is released
    const std::lock_guard lock(mutex_);
    const auto opened = found(handle);
    closed = std::move(opened->second);
    opened_.erase(opened);
  }

 private:
  auto found(const Handle* handle) {
    const auto opened = opened_.find(handle);
    if (opened == opened_.end()) throw InputError(fmt::format("the {} is not open", noun_));
    return opened;
  }

  std::string noun_;
  std::mutex mutex_;
  std::unordered_map<const Handle*, std::shared_ptr<Opened>> opened_;
};

using OpenProblems = OpenHandles<ricochet_problem, OpenedProblem>;

/// All open problems. Never destroyed: a program may close its problems while it ends.
OpenProblems& open_problems();

}  // namespace ricochet::interface
