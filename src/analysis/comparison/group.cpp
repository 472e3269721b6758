#include "src/analysis/comparison/group.h"

#include <algorithm>
#include <utility>

namespace ricochet::studies::comparison {

bool Group::has(const CellResult& result) const {
  return std::find(problems.begin(), problems.end(), result.cell->problem) != problems.end();
}

std::vector<Group> groups_of(const Comparison& comparison) {
  std::vector<Group> groups;
  for (const std::size_t q : comparison.problems()) {
    const std::string& family = comparison.campaign->family_of(q);
    const auto known = std::find_if(groups.begin(), groups.end(),
                                    [&](const Group& group) { return group.family == family; });
    if (known == groups.end()) {
      groups.push_back({family, {q}});
    } else {
      known->problems.push_back(q);
    }
  }
  return groups;
}

Ratings ratings_of(const Comparison& comparison, const std::vector<Group>& groups) {
  Ratings ratings;
  for (const Group& group : groups) {
    auto& of_group = ratings.emplace_back();
    for (std::size_t b = 0; b < comparison.part->budgets.size(); ++b) {
      of_group.push_back(rate(comparison, group.problems, b));
    }
  }
  return ratings;
}

report::Series runtimes_of(const Rating& rating, std::string label) {
  report::Series series{std::move(label), report::Mark::steps, {}};
  auto& samples = series.samples;
  for (const Reach& reach : rating.progress) {
    if (samples.empty()) samples.push_back({reach.evaluations, 0});
    const std::size_t many = samples.size();
    const double share = 100 * reach.share;
    const bool level =
        many > 1 && samples[many - 1].value == share && samples[many - 2].value == share;
    if (level) samples.pop_back();  // its ends suffice
    samples.push_back({reach.evaluations, share});
  }
  return series;
}

std::vector<RatedPart> rated_parts(const Campaign& campaign, const std::vector<CellResult>& results,
                                   const std::vector<ReportedPart>& parts) {
  std::vector<RatedPart> all;
  for (const ReportedPart& part : parts) {
    RatedPart rated{&part, comparison_of(campaign, results, part.usual), {}, {}};
    rated.groups = groups_of(rated.comparison);
    std::erase_if(rated.groups,
                  [&](const Group& group) { return part.asked_again.contains(group.family); });
    for (Group& group : rated.groups) group.family = part.families.at(group.family);
    rated.ratings = ratings_of(rated.comparison, rated.groups);
    all.push_back(std::move(rated));
  }
  return all;
}

}  // namespace ricochet::studies::comparison
