#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/report/json.h"

/// Hard walls against compliant ones: does the count differ, and what does it cost?
namespace ricochet::studies::dynamics {

/// One case of the paper with one stiffness, over several speeds.
struct FidelityCell {
  int equal = 0;     ///< speeds at which both count the same
  int distance = 0;  ///< sum over the speeds of how far the counts are apart
  int compared = 0;  ///< speeds that the compliant simulation came through with
  /// Processor time of the compliant simulations over that of the hard ones; nothing without any.
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
  std::vector<std::vector<FidelityCell>> cells;  ///< a row a case, a cell a stiffness
};

/// Every case of the paper, with the law exact-restitution.
FidelityStudy study_fidelity(const FidelityPlan& plan);

/// Where a compliant wall counts otherwise than a hard one.
report::Json data_of(const FidelityStudy& study);

}  // namespace ricochet::studies::dynamics
