#include "src/research/limits/claims.h"

#include <fmt/format.h>

#include <algorithm>

#include "src/research/limits/order_bound.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

constexpr Part parts_of_a_case[] = {Part::threshold,     Part::count,    Part::purity,
                                    Part::misclassified, Part::loudness, Part::examples};
constexpr double quiet_share_weight = 4;  // as in loss()

const char* word_for(Part part) {
  switch (part) {
    case Part::threshold:
      return "threshold";
    case Part::count:
      return "quiet count";
    case Part::purity:
      return "purity";
    case Part::misclassified:
      return "misclassified speeds";
    case Part::loudness:
      return "loudness";
    case Part::examples:
      return "examples";
    case Part::never_quiet:
      break;
  }
  return "";
}

double share_of(Part part, const LossParts& parts) {
  switch (part) {
    case Part::threshold:
      return parts.threshold;
    case Part::count:
      return parts.count;
    case Part::purity:
      return parts.purity;
    case Part::misclassified:
      return parts.misclassified;
    case Part::loudness:
      return parts.loudness;
    case Part::examples:
      return parts.examples;
    case Part::never_quiet:
      break;
  }
  return 0;
}

/// The parts of all cases.
std::vector<Claimed> claims_of(const std::vector<Part>& parts) {
  std::vector<Claimed> claims;
  for (const Claimed& claim : all_claims()) {
    if (std::ranges::find(parts, claim.part) != parts.end()) claims.push_back(claim);
  }
  return claims;
}

double sum(const CoarseJudgement& judgement, const std::vector<Claimed>& claims, bool of_these) {
  const std::vector<Claimed> all = all_claims();
  const std::vector<double> losses = loss_by_claim(judgement);
  double total = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool among = std::ranges::find(claims, all[i]) != claims.end();
    if (among == of_these) total += losses[i];
  }
  return total;
}

}  // namespace

std::string Claimed::name() const {
  if (part == Part::never_quiet) return "C11 is never quiet";
  return fmt::format("{}'s {}", case_id, word_for(part));
}

std::vector<Claimed> all_claims() {
  std::vector<Claimed> claims;
  for (const Case& c : cases_with_threshold()) {
    for (const Part part : parts_of_a_case) claims.push_back({part, c.id});
  }
  claims.push_back({Part::never_quiet, "C11"});
  return claims;
}

std::vector<double> loss_by_claim(const CoarseJudgement& judgement) {
  std::vector<double> losses;
  for (const CoarseCase& c : judgement.cases) {
    const LossParts parts = loss_parts(c.score, c.the_case.claim);
    for (const Part part : parts_of_a_case) losses.push_back(share_of(part, parts));
  }
  losses.push_back(quiet_share_weight * judgement.quiet_share);
  return losses;
}

std::vector<ClaimGroup> dropped_groups() {
  std::vector<ClaimGroup> groups;
  for (const Part part : {Part::threshold, Part::count, Part::purity}) {
    for (const Claimed& claim : claims_of({part})) groups.push_back({claim.name(), {claim}});
  }
  const Claimed never_quiet = all_claims().back();
  groups.push_back({never_quiet.name(), {never_quiet}});
  groups.push_back({"all examples", claims_of({Part::examples})});
  return groups;
}

std::vector<ClaimGroup> asked_groups() {
  return {{"thresholds", claims_of({Part::threshold})},
          {"counts", claims_of({Part::count})},
          {"purity", claims_of({Part::purity})},
          {"thresholds and counts", claims_of({Part::threshold, Part::count})},
          {"thresholds and purity", claims_of({Part::threshold, Part::purity})},
          {"counts and purity", claims_of({Part::count, Part::purity})},
          {"all claims", all_claims()}};
}

double loss_without(const CoarseJudgement& judgement, const ClaimGroup& dropped) {
  return sum(judgement, dropped.claims, false);
}

double loss_of_only(const CoarseJudgement& judgement, const ClaimGroup& asked) {
  return sum(judgement, asked.claims, true);
}

}  // namespace ricochet::studies::limits
