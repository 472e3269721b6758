#include "src/benchmark/experiment/campaign/completeness.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "src/benchmark/experiment/campaign/planned_runs.h"

namespace ricochet {
namespace {

/// The shards that make up what is missing, the fewest that do; "" if none do. `is_missing` is in
/// the order in which runs are dealt to shards.
std::string shards_of(const std::vector<bool>& is_missing) {
  constexpr std::size_t most_shards = 1000;
  for (std::size_t count = 2; count <= std::min(most_shards, is_missing.size() / 2); ++count) {
    bool fits = true;
    for (std::size_t k = count; k < is_missing.size() && fits; ++k) {
      fits = is_missing[k] == is_missing[k - count];
    }
    if (!fits) continue;
    std::vector<std::size_t> shards;
    for (std::size_t k = 0; k < count; ++k) {
      if (is_missing[k]) shards.push_back(k + 1);
    }
    return fmt::format("shard{} {} of {}", shards.size() == 1 ? "" : "s", fmt::join(shards, ", "),
                       count);
  }
  return "";
}

/// The first of them, and how many more there are.
template <class Names>
std::string listed(const Names& names) {
  constexpr std::size_t most = 5;
  const auto shown = std::min(names.size(), most);
  const std::vector first(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown));
  return fmt::format("{}{}", fmt::join(first, ", "),
                     names.size() > shown ? fmt::format(" and {} more", names.size() - shown) : "");
}

}  // namespace

Completeness completeness_of(const Campaign& campaign, const Store& store) {
  Completeness found;
  for (const StoredSolver& solver : store.description().solvers) {
    const bool known = std::ranges::find(campaign.solvers(), solver.name, &Solver::name) !=
                       campaign.solvers().end();
    if (!known) found.unknown_solvers.push_back(solver.name);
  }
  const std::vector<PlanPart>& parts = campaign.plan().parts;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    found.parts.push_back({parts[k].name.empty() ? fmt::format("part {}", k + 1) : parts[k].name});
  }
  const std::vector<PlannedPlace> planned = planned_places(campaign);
  const std::set<RunKey> keys = store.keys();
  std::vector<bool> is_missing;
  std::set<std::string> problems, solvers;
  std::set<int> instances;
  for (const PlannedPlace& place : planned) {
    const Cell& cell = place.cell->cell;
    const bool there = keys.contains({cell, place.instance, place.run});
    is_missing.push_back(!there);
    found.planned += 1;
    found.present += there ? 1 : 0;
    for (const std::size_t part : place.cell->parts) {
      found.parts[part].planned += 1;
      found.parts[part].present += there ? 1 : 0;
    }
    if (there) continue;
    problems.insert(cell.problem);
    solvers.insert(cell.solver);
    instances.insert(place.instance);
  }
  if (found.missing() > 0 && found.present > 0) found.missing_shards = shards_of(is_missing);
  const std::int64_t others = static_cast<std::int64_t>(keys.size()) - found.present;
  found.planned += others;
  found.present += others;
  found.missing_problems.assign(problems.begin(), problems.end());
  found.missing_solvers.assign(solvers.begin(), solvers.end());
  found.missing_instances.assign(instances.begin(), instances.end());
  return found;
}

std::string in_words(const Completeness& found) {
  std::string unknown;
  if (!found.unknown_solvers.empty()) {
    unknown = fmt::format("; further runs of {} may be missing: this build has no such solver",
                          listed(found.unknown_solvers));
  }
  if (found.missing() == 0) {
    return fmt::format("all {} planned runs are present{}", found.planned, unknown);
  }
  std::string parts;
  for (const Completeness::Part& part : found.parts) {
    if (part.present == part.planned || found.parts.size() == 1) continue;
    parts += fmt::format("; {} of {} of {}", part.present, part.planned, part.name);
  }
  return fmt::format(
      "{} of {} planned runs are present, {} {} missing: {}{}of {}; of {}; on {} {}{}{}",
      found.present, found.planned, found.missing(), found.missing() == 1 ? "is" : "are",
      found.missing_shards, found.missing_shards.empty() ? "" : "; ",
      listed(found.missing_problems), listed(found.missing_solvers),
      found.missing_instances.size() == 1 ? "instance" : "instances",
      listed(found.missing_instances), parts, unknown);
}

std::string as_sentence(const Completeness& completeness) {
  std::string sentence = in_words(completeness) + ".";
  if (sentence.starts_with("all")) sentence[0] = 'A';
  return sentence;
}

}  // namespace ricochet
