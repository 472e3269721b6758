#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/error.h"
#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/export/formats.h"
#include "src/analysis/rating.h"
#include "src/app/campaign.h"
#include "src/app/scene_choice.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/report/text.h"

namespace ricochet::cli {

namespace {

using comparison::entry;
using report::Json;
using studies::comparison::entry_changes;
using studies::comparison::EntryChange;
using studies::comparison::EntryChanges;
using studies::comparison::FamilyAgreement;

std::string family_in_words(const FamilyAgreement& one) {
  return fmt::format(
      "{}: {} and {}; {}; the first of the one ({}{}) {} in the other, "
      "whose first is {}\n",
      one.family, one.problems, report::counted(one.other_problems, "problem"),
      agreement_in_words(one.agreement), one.leader,
      one.best ? fmt::format(", P(best) {:.2f}", *one.best) : "",
      one.place ? fmt::format("has place {}", *one.place) : "is not ranked", one.other_leader);
}

Json json_of(const FamilyAgreement& one) {
  return {{"family", one.family},
          {"problems", one.problems},
          {"other_problems", one.other_problems},
          {"agreement", agreement_json(one.agreement)},
          {"leader", one.leader},
          {"best", report::as_json(one.best)},
          {"place", report::as_json(one.place)},
          {"other_leader", one.other_leader}};
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
    fmt::print("left out, since their hashes differ: {}\n",
               report::counted(changes.other_problems.size(), "problem"));
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
std::vector<FamilyAgreement> agreements(const Store& first, const Store& second) {
  try {
    const FinishedCampaign one = finished_campaign(first);
    const FinishedCampaign other = finished_campaign(second);
    return studies::comparison::family_agreements(one.campaign, one.results, other.campaign,
                                                  other.results);
  } catch (const InputError& error) {
    warn(fmt::format("the orders of the entries are not compared: {}", error.what()));
    return {};
  }
}

}  // namespace

std::string agreement_in_words(const std::optional<studies::comparison::Agreement>& agreement) {
  if (!agreement) return "the orders cannot be compared";
  return fmt::format("Kendall's tau {:.2f} [{:.2f}, {:.2f}] over {} entries",
                     agreement->correlation, agreement->lower, agreement->upper,
                     agreement->entries);
}

Json agreement_json(const std::optional<studies::comparison::Agreement>& agreement) {
  if (!agreement) return nullptr;
  return {{"entries", agreement->entries},
          {"solvers", agreement->solvers},
          {"correlation", agreement->correlation},
          {"lower", agreement->lower},
          {"upper", agreement->upper}};
}

int compare_stores(const std::string& first, const std::string& second, bool json) {
  const Store one = Store::open(archive_named(first), Store::For::reading);
  const Store other = Store::open(archive_named(second), Store::For::reading);
  const auto one_has = told_completeness(one, first);
  const auto other_has = told_completeness(other, second);
  const EntryChanges changes = entry_changes(one, other);
  const auto families = agreements(one, other);
  if (json) {
    const auto json_of_store = [](const auto& has) {
      return has ? exports::json_of(*has) : Json();
    };
    const Json data = {
        {"stores", {json_of_store(one_has), json_of_store(other_has)}},
        {"families", report::list_of(families, [](const auto& family) { return json_of(family); })},
        {"entries", report::list_of(changes.entries,
                                    [](const EntryChange& change) { return json_of(change); })},
        {"other_problems", changes.other_problems}};
    fmt::print("{}\n", data.dump(2, ' ', false, Json::error_handler_t::replace));
    return 0;
  }
  for (const FamilyAgreement& family : families) fmt::print("{}", family_in_words(family));
  print(changes);
  return 0;
}

namespace {

using namespace carrier_track;

/// The SI unit of a constant, "1" for a number without unit.
std::string unit_of(const std::string& constant) {
  if (constant == "clearance") return "m";
  std::string unit = "1";
  Scene scene;
  const auto visit = [&](const SceneField& field, const auto&... /*members*/) {
    if (field.key == constant) unit = field.unit;
  };
  visit_scene_fields(visit, scene);
  visit_count_fields(visit, scene);
  return unit;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The name of the unit that a text ends with; empty if it is a plain number.
std::string unit_in(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return "";
  return std::string(trimmed(text.substr(static_cast<std::size_t>(end - text.data()))));
}

std::optional<double> number_of(std::string_view text, const std::string& unit,
                                const std::string& usual) {
  if (const auto number = number_of_text<double>(text)) {
    return usual.empty() ? number : quantity(fmt::format("{} {}", text, usual), unit);
  }
  return quantity(text, unit);
}

}  // namespace

ConstantRange constant_range_of(const std::string& text) {
  const std::string origin = one_line(fmt::format("--over {}", text));
  const std::size_t equal = text.find('='), dots = text.find("..");
  if (equal == std::string::npos || dots == std::string::npos || dots < equal) {
    throw InputError(origin + ": must be CONSTANT=FROM..TO, as in restitution=0.05..0.95");
  }
  ConstantRange range{std::string(trimmed(std::string_view(text).substr(0, equal))), 0, 0, {}};
  try {
    constant_named(Scene{}, range.constant);
  } catch (const InputError& error) {
    throw InputError(fmt::format("--over {}", one_line(error.what())));
  }
  const std::string unit = unit_of(range.constant);
  const std::string_view all = text;
  const std::string_view from = trimmed(all.substr(equal + 1, dots - equal - 1));
  const std::string_view to = trimmed(all.substr(dots + 2));
  const std::string name = unit_in(to);
  const auto lower = number_of(from, unit, name), upper = number_of(to, unit, name);
  if (!lower || !upper) {
    throw InputError(fmt::format(
        "{}: must be two numbers{}", origin,
        unit == "1" ? ""
                    : fmt::format(", with one of the units {}", fmt::join(units_for(unit), ", "))));
  }
  range.from = *lower;
  range.to = *upper;
  if (unit != "1") range.unit = {name.empty() ? unit : name, 1};
  if (!name.empty()) range.unit.size = *quantity("1 " + name, unit);
  return range;
}

}  // namespace ricochet::cli
