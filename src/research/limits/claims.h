#pragma once

#include <string>
#include <vector>

#include "src/research/limits/coarse_judgement.h"

/// The paper's claims one by one, and the loss as the sum of their contributions: that of the
/// calibration without its share for shape, which is not a claim.
namespace ricochet::studies::limits {

enum class Part { threshold, count, purity, misclassified, loudness, examples, never_quiet };

struct Claimed {
  Part part;
  std::string case_id;  ///< C11 for never_quiet

  std::string name() const;  ///< "C3's threshold", "C11 is never quiet"
  bool operator==(const Claimed&) const = default;
};

/// All 61: six for each of C1..C10, and that C11 is never quiet.
std::vector<Claimed> all_claims();

/// The contribution of each, in the order of all_claims().
std::vector<double> loss_by_claim(const CoarseJudgement& judgement);

/// The same claims as a group that can be dropped, or fitted alone.
struct ClaimGroup {
  std::string name;
  std::vector<Claimed> claims;
};

/// The groups that are dropped one at a time: each threshold, count and purity, that C11 is never
/// quiet, the examples as a whole.
std::vector<ClaimGroup> dropped_groups();

/// The groups that are fitted alone: thresholds; counts; purity; thresholds and counts; thresholds
/// and purity; counts and purity.
std::vector<ClaimGroup> asked_groups();

/// The sum over all claims except these.
double loss_without(const CoarseJudgement& judgement, const ClaimGroup& dropped);

/// The sum over only these.
double loss_of_only(const CoarseJudgement& judgement, const ClaimGroup& asked);

}  // namespace ricochet::studies::limits
