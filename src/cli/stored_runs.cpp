#include "src/cli/stored_runs.h"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "src/benchmark/experiment/campaign/planned_runs.h"
#include "src/benchmark/experiment/campaign/runner.h"
#include "src/benchmark/experiment/campaign/stored_campaign.h"
#include "src/benchmark/experiment/store/store.h"
#include "src/benchmark/experiment/store/stored_parts.h"
#include "src/report/json.h"
#include "src/research/suite/catalogue.h"

namespace ricochet::cli {

using report::Json;

namespace {

/// Repeats a run; nothing if the plan has no such run.
std::optional<RunRecord> made_again(const CampaignDescription& description, const Plan& plan,
                                    const RunKey& key) {
  const Campaign campaign = campaign_of(description, plan, studies::whole_catalogue());
  const PlannedRuns planned(campaign, key);
  std::optional<RunRecord> again;
  if (planned.all().empty()) return again;
  run_all({planned.all().front().job}, plan.limits,
          [&](std::size_t, RunRecord record) { again = std::move(record); });
  return again;
}

}  // namespace

void warn_of_missing_runs(const std::string& store) {
  const std::string warning = caution(store);
  if (!warning.empty()) fmt::print(stderr, "ricochet: {}\n", warning);
}

int merge_stores(const std::vector<std::string>& parts, const std::string& out) {
  merge({parts.begin(), parts.end()}, out);
  const Store store = Store::open(out, Store::For::reading);
  for (const std::string& part : parts) warn_of_missing_runs(part);
  fmt::print("{} runs: {}\ndigest {}\n", store.size(), out, store.digest());
  return 0;
}

int print_digest(const std::string& store) {
  const Store opened = Store::open(store, Store::For::reading);
  warn_of_missing_runs(store);
  fmt::print("{}\n", opened.digest());
  return 0;
}

int replay(const std::string& file, std::int64_t number, bool json) {
  const Store store = Store::open(file, Store::For::reading);
  warn_of_missing_runs(file);
  const auto stored = store.find(number);
  if (!stored) {
    throw InputError(fmt::format("{}: there is no run {}: {} has runs 1 to {}", number, number,
                                 file, store.size()));
  }
  const CampaignDescription& description = store.description();
  const auto found = made_again(description, plan_from(description.plan, file), stored->key);
  if (!found) throw InputError(fmt::format("{}: run {} is none of its plan's", file, number));
  const RunRecord& again = *found;
  const std::string differs = difference(parts_of(again), parts_of(stored->record));
  const Cell& cell = stored->key.cell;
  const Json data = {
      {"run", number},
      {"problem", cell.problem},
      {"formulation", cell.formulation},
      {"perturbation", cell.perturbation},
      {"solver", cell.solver},
      {"budget", cell.budget},
      {"gradient_price", cell.gradient_price},
      {"instance", stored->key.instance},
      {"seed", stored->key.run},
      {"failure", again.failure},
      {"evaluations", again.ledger.charged},
      {"objective", again.trace.empty() ? Json() : Json(again.trace.back().true_values.objective)},
      {"differs", differs},
      {"same", differs.empty()}};
  if (json) {
    fmt::print("{}\n", data.dump(2));
  } else {
    fmt::print(
        "{} on {}, formulation {}, perturbation {}, instance {}, seed {}: {} evaluations{}.\n{}\n",
        cell.solver, cell.problem, cell.formulation, cell.perturbation, stored->key.instance,
        stored->key.run, again.ledger.charged, again.failure.empty() ? "" : "; " + again.failure,
        differs.empty() ? "The same, to the last bit."
                        : "NOT the same as stored: it differs in " + differs + ".");
  }
  return differs.empty() ? 0 : 1;
}

}  // namespace ricochet::cli
