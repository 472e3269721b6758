#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/benchmark/analysis/rating.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// The first entry, and the mean ranks by entry.
struct Order {
  std::string leader;
  std::map<std::string, double> ranks;
};

/// Returns the order of ratings sorted best first; an entry is a solver-formulation pair.
Order order_of(const std::vector<Rating>& ratings);

/// Returns the order of those with this formulation; an entry is a solver.
Order order_in(const std::vector<Rating>& ratings, const std::string& formulation);

/// Agreement of two orders, over the entries in both: "entries", "correlation" (Kendall's), "lower"
/// and "upper". Null for fewer than five entries, or if all are tied.
report::Json agreement_of(const Order& a, const Order& b);

}  // namespace ricochet::studies::comparison
