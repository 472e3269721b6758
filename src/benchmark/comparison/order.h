#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/benchmark/analysis/rating.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

struct Ranked {
  std::string solver;
  double rank;  ///< mean
};

/// The first entry, or "none" if it solved no run, and the ranked entries by name.
struct Order {
  std::string leader = "none";
  std::map<std::string, Ranked> entries;
};

/// Returns the order of ratings sorted best first; an entry is a solver-formulation pair.
Order order_of(const std::vector<Rating>& ratings);

/// Returns the order of those with this formulation; an entry is a solver.
Order order_in(std::vector<Rating> ratings, const std::string& formulation);

/// Agreement of two orders, over the entries in both: "entries", "solvers", "correlation"
/// (Kendall's), "lower" and "upper", by resampling solvers, since entries of one solver are alike.
/// Null for fewer than five solvers, or if all entries are tied.
report::Json agreement_of(const Order& a, const Order& b);

}  // namespace ricochet::studies::comparison
