#pragma once

#include <functional>
#include <vector>

#include "src/contest/outcomes.h"
#include "src/store/store.h"

namespace ricochet::exports {

/// A run of a store, and what the suite says of it.
struct JudgedRun {
  const StoredQuestion& question;
  const StoredRun& stored;
  const contest::Outcome& outcome;
};

/// All runs that differ in instance and number only.
struct JudgedCell {
  const Cell& cell;
  const StoredQuestion& question;
  contest::Outcomes outcomes;  ///< at least one
};

/// Hands over every run of the store, by cell, and every cell after its last run. Only the runs of
/// one cell are kept in memory. Throws InputError where the store is damaged.
void each_judged(const Store& store, const std::function<void(const JudgedRun&)>& use,
                 const std::function<void(const JudgedCell&)>& at_end);

}  // namespace ricochet::exports
