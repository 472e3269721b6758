#include "src/research/limits/exclusions.h"

#include <algorithm>
#include <limits>

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

constexpr std::size_t gains_told = 3;
constexpr double least_gain = 0.05;  // of a tolerance

Target target_without(const ClaimGroup& dropped) {
  return {"without " + dropped.name, false,
          [dropped](const CoarseJudgement& judgement) { return loss_without(judgement, dropped); }};
}

std::vector<GoalSearch> from_each(const std::vector<Fit>& starts, const Target& target, int seed,
                                  const ExclusionPlan& plan) {
  std::vector<GoalSearch> searches;
  for (const Fit& start : starts) {
    searches.push_back({{start.interpretation, start.free, start.constants},
                        target,
                        plan.solver,
                        seed,
                        plan.evaluations,
                        true});
  }
  return searches;
}

/// The fit with the lowest value among some final ones.
const Fit& best_of(const std::vector<GoalFound>& found, std::size_t first, std::size_t count) {
  const auto begin = found.begin() + static_cast<std::ptrdiff_t>(first);
  return std::min_element(
             begin, begin + static_cast<std::ptrdiff_t>(count),
             [](const GoalFound& a, const GoalFound& b) { return a.whole.loss < b.whole.loss; })
      ->whole;
}

std::vector<Exclusion::Gain> gains_of(const Exclusion& e, const CoarseJudgement& control,
                                      const CoarseJudgement& without) {
  const std::vector<Claimed> claims = all_claims();
  const std::vector<double> before = loss_by_claim(control);
  const std::vector<double> after = loss_by_claim(without);
  std::vector<Exclusion::Gain> gains;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (std::ranges::find(e.dropped.claims, claims[i]) != e.dropped.claims.end()) continue;
    gains.push_back({claims[i].name(), before[i] - after[i]});
  }
  std::ranges::stable_sort(gains, std::greater(), &Exclusion::Gain::gain);
  std::erase_if(gains, [](const Exclusion::Gain& g) { return g.gain < least_gain; });
  if (gains.size() > gains_told) gains.resize(gains_told);
  return gains;
}

}  // namespace

double Exclusions::spread() const {
  const auto [lowest, highest] = std::minmax_element(controls.begin(), controls.end());
  return *highest - *lowest;
}

Exclusions exclusions(const std::vector<Fit>& starts, const ExclusionPlan& plan, FitStore& store) {
  const std::vector<ClaimGroup> groups = dropped_groups();
  const Target everything = target_without({"nothing", {}});
  std::vector<GoalSearch> searches;
  const auto append = [&](const Target& target, int seed) {
    for (GoalSearch& search : from_each(starts, target, seed, plan)) {
      searches.push_back(std::move(search));
    }
  };
  for (const int seed : plan.control_seeds) append(everything, seed);
  for (const ClaimGroup& group : groups) append(target_without(group), plan.control_seeds.front());
  const std::vector<GoalFound> found = searched(searches, "one claim dropped at a time", store);

  Exclusions result{std::numeric_limits<double>::infinity(), {}, {}};
  for (const Fit& start : starts) {
    result.start = std::min(result.start, value_of(everything, start));
  }
  for (std::size_t k = 0; k < plan.control_seeds.size(); ++k) {
    result.controls.push_back(best_of(found, k * starts.size(), starts.size()).loss);
  }
  const Fit& control = best_of(found, 0, starts.size());
  const CoarseJudgement with_all = judged_coarsely(control.interpretation, control.constants);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::size_t first = (plan.control_seeds.size() + g) * starts.size();
    const Fit& without = best_of(found, first, starts.size());
    Exclusion& e = result.all.emplace_back();
    e.dropped = groups[g];
    e.its_share = loss_of_only(with_all, groups[g]);
    e.rest = loss_without(with_all, groups[g]);
    e.rest_without = without.loss;
    e.gains = gains_of(e, with_all, judged_coarsely(without.interpretation, without.constants));
  }
  std::ranges::stable_sort(result.all, std::greater(), &Exclusion::relief);
  return result;
}

}  // namespace ricochet::studies::limits
