#pragma once

#include <functional>
#include <vector>

#include "src/benchmark/analysis/outcomes.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet::comparison {

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

}  // namespace ricochet::comparison
