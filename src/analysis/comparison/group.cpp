#include "src/analysis/comparison/group.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "src/analysis/comparison/solver_pages.h"

namespace ricochet::studies::comparison {

bool Group::has(const CellResult& result) const {
  return std::find(problems.begin(), problems.end(), result.cell->problem) != problems.end();
}

Comparison comparison_in(const Campaign& campaign, const std::vector<CellResult>& results,
                         const ReportedPart& part, const Conditions& conditions) {
  Comparison comparison = comparison_of(campaign, results, conditions);
  std::erase_if(comparison.results, [&](const CellResult& result) {
    return part.silent.contains(result.cell->problem);
  });
  return comparison;
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

namespace {

/// The share of targets reached [%] over the evaluations, from nothing on, with a sample only where
/// it rises and at its end.
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

}  // namespace

report::Chart runtime_ecdf(const std::string& family, std::int64_t budget,
                           const std::vector<Rating>& ratings) {
  constexpr std::size_t told = 5, shown = 6;  // more lines cannot be distinguished, or seen
  std::vector<report::Series> first, paper, rest;
  std::set<std::string> drawn;
  for (const Rating& rating : ratings) {
    const std::string name = entry(rating.solver, rating.formulation);
    if (first.size() < told) {
      first.push_back(runtimes_of(rating, name));
    } else if (drawn.contains(rating.solver)) {
      continue;
    } else if (rating.solver == paper_solver) {
      paper.push_back(runtimes_of(rating, name + " (the paper's)"));
      paper.back().dark = true;
    } else if (rest.size() < shown) {
      rest.push_back(runtimes_of(rating, ""));
      rest.back().pale = true;
    }
    drawn.insert(rating.solver);
  }
  report::Chart chart{
      .name = fmt::format("ecdf-{}", budget),
      .title = fmt::format("{}: {}, {} reaches {:.0f} % of the targets in {} evaluations a "
                           "variable",
                           family, ratings.front().solver, ratings.front().formulation,
                           100 * ratings.front().progress.back().share, budget),
      .x = {"evaluations for each variable", report::Scale::logarithmic},
      .y = {"targets reached [%]", report::Scale::linear, report::Range{0, 100}},
      .width = 720,
      .height = 380};
  for (auto* series : {&rest, &first, &paper}) {
    chart.series.insert(chart.series.end(), series->begin(), series->end());
  }
  return chart;
}

std::vector<RatedPart> rated_parts(const Campaign& campaign, const std::vector<CellResult>& results,
                                   const std::vector<ReportedPart>& parts) {
  std::vector<RatedPart> all;
  for (const ReportedPart& part : parts) {
    RatedPart rated{&part, comparison_in(campaign, results, part, part.usual), {}, {}};
    rated.groups = groups_of(rated.comparison);
    std::erase_if(rated.groups,
                  [&](const Group& group) { return part.asked_again.contains(group.family); });
    for (Group& group : rated.groups) group.family = part.families.at(group.family);
    rated.ratings = ratings_of(rated.comparison, rated.groups);
    if (part.by_differences) {
      rated.by_differences = comparison_in(campaign, results, part, *part.by_differences);
      rated.ratings_by_differences = ratings_of(*rated.by_differences, rated.groups);
    }
    all.push_back(std::move(rated));
  }
  return all;
}

}  // namespace ricochet::studies::comparison
