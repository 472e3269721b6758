#pragma once

#include <string>
#include <vector>

#include "src/studies/limits/coarse_judgement.h"

/// The paper's claims one by one, and the misfit as the sum of what each adds: that of the
/// calibration, but for its share for shape, which is no claim.
namespace ricochet::studies::limits {

enum class Part { threshold, count, purity, misclassified, loudness, examples, never_quiet };

struct Claimed {
  Part part;
  std::string case_id;  ///< of never_quiet C11

  std::string name() const;  ///< "C3's threshold", "C11 is never quiet"
  bool operator==(const Claimed&) const = default;
};

/// All 61: six for each of C1..C10, and that C11 is never quiet.
std::vector<Claimed> all_claims();

/// What each adds, in the order of all_claims().
std::vector<double> misfit_by_claim(const CoarseJudgement& judgement);

/// The same claims as a group that may be dropped, or asked for alone.
struct ClaimGroup {
  std::string name;
  std::vector<Claimed> claims;
};

/// What is dropped, one after the other: each threshold, count and purity, that C11 is never quiet,
/// the examples as a whole.
std::vector<ClaimGroup> dropped_groups();

/// What is asked for alone: thresholds; counts; purity; thresholds and counts; thresholds and
/// purity; counts and purity. An asked one brings no other.
std::vector<ClaimGroup> asked_groups();

/// The sum over all claims but these.
double misfit_without(const CoarseJudgement& judgement, const ClaimGroup& dropped);

/// The sum over these alone.
double misfit_of_only(const CoarseJudgement& judgement, const ClaimGroup& asked);

}  // namespace ricochet::studies::limits
