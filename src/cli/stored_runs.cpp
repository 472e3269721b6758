#include "src/cli/stored_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "src/campaign/planned_runs.h"
#include "src/campaign/runner.h"
#include "src/core/error.h"
#include "src/report/json.h"
#include "src/store/store.h"
#include "src/store/stored_parts.h"
#include "src/studies/contest/catalogue.h"

namespace ricochet::cli {

using report::Json;

namespace {

/// Nothing where the plan has no such run. Part by part, those without a grid of machines first,
/// which would have to be scanned.
std::optional<RunRecord> made_again(const Plan& plan, const RunKey& key) {
  std::vector<PlanPart> parts = plan.parts;
  std::stable_partition(parts.begin(), parts.end(),
                        [](const PlanPart& part) { return part.machines.around.empty(); });
  const Catalogue catalogue = studies::whole_catalogue();
  for (const PlanPart& part : parts) {
    Plan alone = plan;
    alone.parts = {part};
    const Campaign campaign(alone, catalogue);
    const PlannedRuns planned(campaign, key);
    if (planned.all().empty()) continue;
    std::optional<RunRecord> again;
    run_all({planned.all().front().job}, plan.limits,
            [&](std::size_t, RunRecord record) { again = std::move(record); });
    return again;
  }
  return std::nullopt;
}

}  // namespace

int merge_stores(const std::vector<std::string>& parts, const std::string& out) {
  merge({parts.begin(), parts.end()}, out);
  const Store store = Store::open(out, Store::For::reading);
  fmt::print("{} runs: {}\ndigest {}\n", store.size(), out, store.digest());
  return 0;
}

int print_digest(const std::string& store) {
  fmt::print("{}\n", Store::open(store, Store::For::reading).digest());
  return 0;
}

int replay(const std::string& file, std::int64_t number, bool json) {
  const Store store = Store::open(file, Store::For::reading);
  const auto stored = store.find(number);
  if (!stored) {
    throw InputError(fmt::format("{}: there is no run {}: {} has runs 1 to {}", number, number,
                                 file, store.size()));
  }
  const auto found = made_again(plan_from(store.description().plan, file), stored->key);
  if (!found) throw InputError(fmt::format("{}: run {} is none of its plan's", file, number));
  const RunRecord& again = *found;
  const std::string differs = difference(parts_of(again), parts_of(stored->record));
  const Cell& cell = stored->key.cell;
  const Json data = {
      {"run", number},
      {"question", cell.question},
      {"form", cell.form},
      {"feature", cell.feature},
      {"solver", cell.solver},
      {"budget", cell.budget},
      {"gradient_price", cell.gradient_price},
      {"instance", stored->key.instance},
      {"seed", stored->key.run},
      {"failure", again.failure},
      {"evaluations", again.ledger.charged},
      {"objective", again.trace.empty() ? Json() : Json(again.trace.back().truth.objective)},
      {"differs", differs},
      {"same", differs.empty()}};
  if (json) {
    fmt::print("{}\n", data.dump(2));
  } else {
    fmt::print("{} on {}, shown {}, feature {}, instance {}, seed {}: {} evaluations{}.\n{}\n",
               cell.solver, cell.question, cell.form, cell.feature, stored->key.instance,
               stored->key.run, again.ledger.charged,
               again.failure.empty() ? "" : "; " + again.failure,
               differs.empty() ? "The same, to the last bit."
                               : "NOT the same as stored: it differs in " + differs + ".");
  }
  return differs.empty() ? 0 : 1;
}

}  // namespace ricochet::cli
