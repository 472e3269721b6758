#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/report/json.h"

/// Hard against compliant walls: does the count differ, and at what cost?
namespace ricochet::studies::dynamics {

/// One case of the paper with one stiffness over several speeds.
struct FidelityCell {
  int equal = 0;     ///< speeds with equal counts
  int distance = 0;  ///< sum of the count differences over the speeds
  int compared = 0;  ///< speeds at which the compliant simulation finished
  /// Processor time of the compliant simulations over that of the hard ones; nothing if there are
  /// none.
  std::optional<double> cost;

  std::optional<double> share() const {
    return compared > 0 ? std::optional(static_cast<double>(equal) / compared) : std::nullopt;
  }
};

struct FidelityPlan {
  std::vector<double> speeds;       ///< [rad/s]
  std::vector<double> stiffnesses;  ///< [N/m^1.5]
};

struct FidelityStudy {
  FidelityPlan plan;
  std::vector<std::string> cases;                ///< ids
  std::vector<std::vector<FidelityCell>> cells;  ///< a row for each case, a cell for each stiffness
};

/// Every case of the paper, with the law exact-restitution.
FidelityStudy study_fidelity(const FidelityPlan& plan);

/// All cases with one stiffness.
struct FidelityTotal {
  std::string stiffness = {};
  int compared = 0;
  int equal = 0;
  std::optional<double> share = {},
                        distance = {};  ///< equal, and the mean distance, of those compared
  int unfinished = 0;
  std::optional<double> least_cost = {}, most_cost = {};  ///< of a case
};
RICOCHET_WRITTEN_AS_JSON(FidelityTotal, stiffness, compared, equal, share, distance, unfinished,
                         least_cost, most_cost);

struct FidelityShares {
  std::string case_;
  std::vector<std::optional<double>> equal;  ///< one for each stiffness
};
RICOCHET_WRITTEN_AS_JSON(FidelityShares, case_, equal);

struct TriedSpeeds {
  std::size_t tried;
  double first, last;  ///< [rad/s]
};
RICOCHET_WRITTEN_AS_JSON(TriedSpeeds, tried, first, last);

struct FidelityData {
  std::size_t cases;
  TriedSpeeds speeds;
  std::vector<FidelityTotal> stiffnesses;
  std::vector<FidelityShares> shares;
};
RICOCHET_WRITTEN_AS_JSON(FidelityData, cases, speeds, stiffnesses, shares);

/// Where the counts of compliant and hard walls differ.
FidelityData data_of(const FidelityStudy& study);

}  // namespace ricochet::studies::dynamics
