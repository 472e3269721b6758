#include "src/cli/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "ricochet/error.h"
#include "src/benchmark/analysis/rating.h"
#include "src/benchmark/comparison/agreement_data.h"
#include "src/benchmark/comparison/entry_changes.h"
#include "src/benchmark/export/json_lines.h"
#include "src/cli/agreement_text.h"
#include "src/cli/archive.h"
#include "src/cli/finished_campaign.h"
#include "src/cli/stored_runs.h"
#include "src/core/one_line.h"
#include "src/core/warning.h"

namespace ricochet::cli {
namespace {

using comparison::entry;
using report::Json;
using studies::comparison::entry_changes;
using studies::comparison::EntryChange;
using studies::comparison::EntryChanges;

std::string family_in_words(const Json& row) {
  const std::string leader = row["leader"];
  const std::string sure =
      row["best"].is_null() ? "" : fmt::format(", P(best) {:.2f}", row["best"].get<double>());
  const std::string place = row["place"].is_null()
                                ? "is not ranked"
                                : fmt::format("has place {}", row["place"].get<int>());
  return fmt::format(
      "{}: {} and {} problems; {}; the first of the one ({}{}) {} in the other, "
      "whose first is {}\n",
      row["family"].get<std::string>(), row["problems"].get<int>(),
      row["other_problems"].get<int>(), agreement_in_words(row["agreement"]), leader, sure, place,
      row["other_leader"].get<std::string>());
}

std::string entry_in_words(const EntryChange& change) {
  std::string name = entry(change.solver, change.formulation);
  if (change.perturbation != "plain") name += "/" + change.perturbation;
  if (change.gradient_price != "n") name += ", gradients at " + change.gradient_price;
  if (change.version != change.other_version) {
    name += fmt::format(" ({}, then {})", change.version, change.other_version);
  }
  return one_line(fmt::format(
             "{}: {} (p = {:.2g}); {:.2f} times the evaluations, fewer on {} and more on {} of {} "
             "problems",
             name, change.sure() ? "changed" : "not significant", change.p_value, change.ratio,
             change.cheaper, change.dearer, change.problems)) +
         "\n";
}

void print(const EntryChanges& changes) {
  const auto same = std::ranges::count_if(changes.entries, &EntryChange::same);
  for (const EntryChange& change : changes.entries) {
    if (!change.same()) fmt::print("{}", entry_in_words(change));
  }
  if (same > 0) fmt::print("{} of {} entries: the same\n", same, changes.entries.size());
  if (changes.entries.empty()) {
    fmt::print("no entry has runs on the same instances with the same budget in both\n");
  }
  if (!changes.other_problems.empty()) {
    fmt::print("{} problems are left out, since their hashes differ\n",
               changes.other_problems.size());
  }
}

Json json_of(const EntryChange& change) {
  return {{"solver", change.solver},
          {"formulation", change.formulation},
          {"perturbation", change.perturbation},
          {"gradient_price", change.gradient_price},
          {"version", change.version},
          {"other_version", change.other_version},
          {"problems", change.problems},
          {"cheaper", change.cheaper},
          {"dearer", change.dearer},
          {"ratio", change.ratio},
          {"p", change.p_value},
          {"sure", change.sure()}};
}

/// The agreement by family; empty, with a warning, if a campaign cannot be made or is not complete.
Json agreements(const Store& first, const Store& second) {
  try {
    const FinishedCampaign one = finished_campaign(first);
    const FinishedCampaign other = finished_campaign(second);
    return studies::comparison::agreement_data(one.campaign, one.results, other.campaign,
                                               other.results);
  } catch (const InputError& error) {
    warn(fmt::format("the orders of the entries are not compared: {}", error.what()));
    return Json::array();
  }
}

}  // namespace

int compare_stores(const std::string& first, const std::string& second, bool json) {
  const Store one = Store::open(archive_named(first), Store::For::reading);
  const Store other = Store::open(archive_named(second), Store::For::reading);
  const auto one_has = told_completeness(one, first);
  const auto other_has = told_completeness(other, second);
  const EntryChanges changes = entry_changes(one, other);
  const Json families = agreements(one, other);
  if (json) {
    const auto json_of_store = [](const auto& has) {
      return has ? exports::json_of(*has) : Json();
    };
    const Json data = {{"stores", {json_of_store(one_has), json_of_store(other_has)}},
                       {"families", families},
                       {"entries", report::list_of(changes.entries, json_of)},
                       {"other_problems", changes.other_problems}};
    fmt::print("{}\n", data.dump(2, ' ', false, Json::error_handler_t::replace));
    return 0;
  }
  for (const Json& row : families) fmt::print("{}", family_in_words(row));
  print(changes);
  return 0;
}

}  // namespace ricochet::cli
