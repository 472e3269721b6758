#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/error.h"
#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/export/formats.h"
#include "src/analysis/rating.h"
#include "src/app/campaign.h"
#include "src/app/command_line.h"
#include "src/core/progress.h"
#include "src/report/table.h"
#include "src/report/text.h"

namespace ricochet::studies::comparison {

RICOCHET_FIELDS(Agreement, entries, solvers, correlation, lower, upper);
RICOCHET_FIELDS(FamilyAgreement, family, problems, other_problems, agreement, leader, best, place,
                other_leader);

}  // namespace ricochet::studies::comparison

namespace ricochet::cli {

namespace {

using report::Json;
using namespace studies::comparison;

Table family_table(const std::vector<FamilyAgreement>& families) {
  Table table{"families",
              {{"family"},
               {"problems"},
               {"other_problems", "problems there"},
               {"entries"},
               {"correlation", "Kendall's tau", ".2f"},
               {"lower", "95 % from", ".2f"},
               {"upper", "to", ".2f"},
               {"leader", "first"},
               {"best", "P(best)", ".2f"},
               {"place", "its place there"},
               {"other_leader", "first there"}}};
  for (const FamilyAgreement& one : families) {
    table.add(
        one.family, one.problems, one.other_problems, value_of(one.agreement, &Agreement::entries),
        value_of(one.agreement, &Agreement::correlation),
        value_of(one.agreement, &Agreement::lower), value_of(one.agreement, &Agreement::upper),
        one.leader, one.best, one.place, one.other_leader);
  }
  return table;
}

Table change_table(const std::vector<EntryChange>& entries) {
  Table table{"entries",
              {{"solver"},
               {"formulation"},
               {"perturbation"},
               {"gradient_price", "gradients at"},
               {"version"},
               {"other_version", "version there"},
               {"problems"},
               {"cheaper", "fewer evaluations on"},
               {"dearer", "more on"},
               {"ratio", "times the evaluations", ".2f"},
               {"p", "", ".2g"},
               {"sure", "significant"}}};
  for (const EntryChange& one : entries) {
    table.add(one.solver, one.formulation, one.perturbation, one.gradient_price, one.version,
              one.other_version, one.problems, one.cheaper, one.dearer, one.ratio, one.p_value,
              one.sure());
  }
  return table;
}

/// The agreement by family; empty, with a warning, if a campaign cannot be made or is not complete.
std::vector<FamilyAgreement> agreements(const Store& first, const Store& second) {
  try {
    const FinishedCampaign one = finished_campaign(first);
    const FinishedCampaign other = finished_campaign(second);
    return family_agreements(one.campaign, one.results, other.campaign, other.results);
  } catch (const InputError& error) {
    warn(fmt::format("the orders of the entries are not compared: {}", error.what()));
    return {};
  }
}

/// The entries that changed, and how many did not.
void print_changes(const EntryChanges& changes) {
  std::vector<EntryChange> changed = changes.entries;
  const auto same = std::erase_if(changed, [](const EntryChange& one) { return one.same(); });
  if (!changed.empty()) {
    print_table(only(change_table(changed),
                     {"solver", "formulation", "perturbation", "gradient_price", "ratio", "cheaper",
                      "dearer", "problems", "p", "sure", "version", "other_version"}),
                false);
  }
  if (same > 0) fmt::print("{} of {} entries: the same\n", same, changes.entries.size());
  if (changes.entries.empty()) {
    fmt::print("no entry has runs on the same instances with the same budget in both\n");
  }
  if (!changes.other_problems.empty()) {
    fmt::print(
        "left out, since their hashes differ: {}\n",
        report::counted(static_cast<std::int64_t>(changes.other_problems.size()), "problem"));
  }
}

}  // namespace

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
    const Json data = {{"stores", {json_of_store(one_has), json_of_store(other_has)}},
                       {"families", report::as_json(families)},
                       {"entries", json_rows_of(change_table(changes.entries))},
                       {"other_problems", changes.other_problems}};
    fmt::print("{}\n", data.dump(2, ' ', false, Json::error_handler_t::replace));
    return 0;
  }
  if (!families.empty()) print_table(family_table(families), false);
  print_changes(changes);
  return 0;
}

namespace {

struct SampleOptions {
  std::string archive;
  double share = 0.15;
  bool json = false;
};

constexpr std::size_t least_problems = 3;

Table sample_table(const std::vector<SampledFamily>& families) {
  Table table{"families",
              {{"family"},
               {"problems"},
               {"of"},
               {"correlation", "Kendall's tau", ".2f"},
               {"lower", "95 % from", ".2f"},
               {"upper", "to", ".2f"},
               {"leader", "first of all"},
               {"returned", "success rate [%]", ".0%"},
               {"best", "P(best)", ".2f"},
               {"sample_leader", "first on the sample"}}};
  for (const SampledFamily& one : families) {
    table.add(
        one.family, one.problems.size(), one.of, value_of(one.agreement, &Agreement::correlation),
        value_of(one.agreement, &Agreement::lower), value_of(one.agreement, &Agreement::upper),
        one.leader, one.returned, one.best, one.sample_leader);
  }
  return table;
}

Json json_of(const SampledFamily& family) {
  return {{"family", family.family},
          {"of", family.of},
          {"problems",
           report::list_of(family.problems,
                           [](const auto& one) {
                             return Json{{"problem", one.first}, {"difficulty", one.second}};
                           })},
          {"agreement", report::as_json(family.agreement)},
          {"leader", family.leader},
          {"returned", report::as_json(family.returned)},
          {"best", report::as_json(family.best)},
          {"sample_leader", family.sample_leader}};
}

int sample_problems(const SampleOptions& options) {
  const double share = options.share;
  if (!(share > 0 && share <= 1)) {
    throw InputError(fmt::format("--share {}: must be in (0, 1]", share));
  }
  const FinishedCampaign finished =
      finished_campaign(Store::open(archive_named(options.archive), Store::For::reading));
  const auto families =
      sampled_families(finished.campaign, finished.results, share, least_problems);
  if (options.json) {
    fmt::print("{}\n",
               report::list_of(families, [](const auto& one) { return json_of(one); }).dump(2));
    return 0;
  }
  print_table(sample_table(families), false);
  Table drawn{"problems", {{"family"}, {"problem"}, {"difficulty", "", ".2f"}}};
  for (const SampledFamily& family : families) {
    for (const auto& [problem, difficulty] : family.problems) {
      drawn.add(family.family, problem, difficulty);
    }
  }
  fmt::print("\n");
  print_table(drawn, false);
  return 0;
}

}  // namespace

void add_sample(CommandLine& line, CLI::App* plan) {
  CLI::App* sample =
      line.add_part(plan, "sample",
                    "Print a sample of an archive's problems, evenly over difficulty, and "
                    "how far its ranking agrees with that of all");
  const auto options = std::make_shared<SampleOptions>();
  add_value(sample, "archive", options->archive, "An archive; archive: that of the reference",
            "ARCHIVE")
      ->required();
  add_value(sample, "--share", options->share, "Of each family; at least three problems");
  add_format(sample, options->json);
  line.on_call(sample, [options] { return sample_problems(*options); });
}

}  // namespace ricochet::cli
