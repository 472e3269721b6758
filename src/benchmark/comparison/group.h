#pragma once

#include <string>
#include <vector>

#include "src/benchmark/analysis/comparison.h"
#include "src/benchmark/analysis/rating.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// Problems of one family, which are rated together.
struct Group {
  std::string family;
  std::vector<std::size_t> problems;  ///< indices in the campaign

  bool has(const CellResult& result) const;
};

/// Returns the families of the problems that are compared, in the order of their first problems.
std::vector<Group> groups_of(const Comparison& comparison);

/// Ratings, best first, by either criterion.
struct BothRatings {
  std::vector<Rating> by_returned, by_evaluated;
};

/// For each group and each budget of the part.
using Ratings = std::vector<std::vector<BothRatings>>;
Ratings ratings_of(const Comparison& comparison, const std::vector<Group>& groups);

/// Returns, for each group, the ratings for each budget, its problems and, if there are few, all
/// results on them.
report::Json group_data(const Comparison& comparison, const std::vector<Group>& groups,
                        const Ratings& ratings);

}  // namespace ricochet::studies::comparison
