#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "embedded/reproduction_plan.h"
#include "embedded/reproduction_quick_plan.h"
#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/solver_pages.h"
#include "src/core/progress.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/stored_campaign.h"
#include "src/studies/reproduction/study.h"

/// A small comparison of solvers on the problems of the paper's cases.
namespace ricochet::studies::reproduction {

namespace {

using namespace comparison;

constexpr std::size_t told_entries = 3;  // of a family, beside random search and the paper's solver

/// A store of another plan, program or data is replaced: its runs take seconds.
StoredCampaign opened(const Plan& plan, const std::filesystem::path& file,
                      const Provenance& provenance) {
  // Problems of the literature are left out: compiling them would double the time to the first
  // report.
  const Catalogue catalogue{carrier_track::case_families(), all_solvers(), {}, {}, {}, {}, {}};
  if (std::filesystem::exists(file)) Store::open(file, Store::For::reading);
  try {
    return stored_campaign(plan, catalogue, file, provenance);
  } catch (const InputError& error) {
    if (!std::filesystem::remove(file)) throw;
    Progress::announce(fmt::format("{}; it is computed again", error.what()));
    return stored_campaign(plan, catalogue, file, provenance);
  }
}

/// The first entries, and the best ones of the paper's solver and of random search.
std::vector<const Rating*> told_ratings(const std::vector<Rating>& ratings) {
  std::vector<const Rating*> told;
  std::set<std::string> solvers;
  for (const Rating& rating : ratings) {
    const bool asked = rating.solver == paper_solver || rating.solver == "random-search";
    if (told.size() < told_entries || (asked && !solvers.contains(rating.solver)))
      told.push_back(&rating);
    solvers.insert(rating.solver);
  }
  return told;
}

}  // namespace

void add_solvers(bool quick, const std::filesystem::path& file, const Provenance& provenance,
                 report::Results& results) {
  const Plan plan =
      quick ? plan_from(embedded::reproduction_quick_plan, "reports/plans/reproduction_quick.toml")
            : plan_from(embedded::reproduction_plan, "reports/plans/reproduction.toml");
  StoredCampaign stored = opened(plan, file, provenance);
  make_runs(stored.campaign, {}, stored.store);
  const Comparison compared =
      comparison_of(stored.campaign, cell_results(stored.campaign, stored.store), Conditions());
  const std::vector<Group> groups = groups_of(compared);
  const Ratings ratings = ratings_of(compared, groups);
  Table table{"solvers",
              {{"family"},
               {"problems"},
               {"solver"},
               {"formulation"},
               {"rank", "mean rank", ".1f", 3},
               {"best", "P(best)", ".2f"},
               {"returned", "success rate [%]", ".0%", 3},
               {"share", "targets reached [%]", ".0%", 3},
               {"lower", "", ".0%", 4},
               {"upper", "", ".0%", 4}}};
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::vector<Rating>& by_returned = ratings[g].back();
    if (by_returned.empty()) continue;
    for (const Rating* r : told_ratings(by_returned)) {
      const Reach& last = r->progress.back();
      table.add(groups[g].family, groups[g].problems.size(), r->solver, r->formulation, r->rank,
                r->probability_of_being_best, r->returned, last.share, last.interval.lower,
                last.interval.upper);
    }
    if (results.chart("runtimes") != nullptr) continue;
    report::Chart chart =
        runtime_ecdf(groups[g].family, compared.part->budgets.back(), by_returned);
    chart.name = "runtimes";
    results.add(std::move(chart));
  }
  results.add(std::move(table));
  std::set<std::string> versions;
  for (const Solver& solver : stored.campaign.solvers()) versions.insert(solver.version);
  results.set("libraries", fmt::format("{}", fmt::join(versions, ", ")));
  results.set("problems", stored.campaign.problems().size());
  results.set("instances", compared.part->instances);
  results.set("evaluations", compared.part->budgets.back());
}

}  // namespace ricochet::studies::reproduction
