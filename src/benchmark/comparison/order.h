#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/contest/rating.h"
#include "src/report/json.h"

namespace ricochet::studies::contest {

using namespace ricochet::contest;

/// Who is first, and the mean ranks by competitor.
struct Order {
  std::string leader;
  std::map<std::string, double> ranks;
};

/// Of ratings with the best first: a competitor is a solver with a form.
Order order_of(const std::vector<Rating>& ratings);

/// Of those among them that are shown this form: a competitor is a solver.
Order order_in(const std::vector<Rating>& ratings, const std::string& form);

/// How alike two orders are, of those that are in both: "competitors", "correlation" (Kendall's),
/// "lower" and "upper". Null of fewer than five, or where all are equal.
report::Json agreement_of(const Order& a, const Order& b);

}  // namespace ricochet::studies::contest
