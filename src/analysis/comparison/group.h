#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/rating.h"
#include "src/analysis/results.h"
#include "src/report/chart.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// Problems of one family, which are rated together.
struct Group {
  std::string family;
  std::vector<std::size_t> problems;  ///< indices in the campaign

  bool has(const CellResult& result) const;
};

/// The results of a part under its own or these conditions, without its silent problems.
Comparison comparison_in(const Campaign& campaign, const std::vector<CellResult>& results,
                         const ReportedPart& part, const Conditions& conditions);

/// Returns the families of the problems that are compared, in the order of their first problems.
std::vector<Group> groups_of(const Comparison& comparison);

/// For each group and each budget of the part, best first.
using Ratings = std::vector<std::vector<std::vector<Rating>>>;
Ratings ratings_of(const Comparison& comparison, const std::vector<Group>& groups);

/// The ECDF of runtimes of the best five entries, the paper's algorithm and, grey, other solvers.
report::Chart runtime_ecdf(const std::string& family, std::int64_t budget,
                           const std::vector<Rating>& ratings);

/// A part of the plan with its families, as the report names them, rated.
struct RatedPart {
  const ReportedPart* part;
  Comparison comparison;
  std::vector<Group> groups;  ///< without those that an earlier part has
  Ratings ratings;            ///< of the groups
  /// The same with gradients by differences, if the part has that price beside the usual one.
  std::optional<Comparison> by_differences = {};
  Ratings ratings_by_differences = {};

  const std::vector<Rating>& most(std::size_t group) const { return ratings[group].back(); }
};

/// Calls `use` with each part and the number of each of its groups.
template <class Use>
void each_group(const std::vector<RatedPart>& parts, const Use& use) {
  for (const RatedPart& part : parts) {
    for (std::size_t g = 0; g < part.groups.size(); ++g) use(part, g);
  }
}

/// Campaign, results and parts must outlive them.
std::vector<RatedPart> rated_parts(const Campaign& campaign, const std::vector<CellResult>& results,
                                   const std::vector<ReportedPart>& parts);

}  // namespace ricochet::studies::comparison
