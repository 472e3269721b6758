#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/experiment/planned_runs.h"
#include "tests/analysis/valley.h"
#include "tests/support/files.h"

namespace ricochet::comparison {

/// A campaign on the valley, whose runs are made.
class HeldCampaign : public TemporaryFolder {
 protected:
  /// `formulations` and `budgets` as a plan has them.
  void hold(std::vector<Solver> solvers, const std::string& budgets, int instances,
            const Shard& shard = {}, const std::string& formulations = "\"*\"") {
    Catalogue catalogue;
    catalogue.families = {{"valley", {valley_problem()}}};
    catalogue.solvers = std::move(solvers);
    const std::string plan = fmt::format(
        "[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = {}\ninstances = {}\nformulations = "
        "{}\n",
        budgets, instances, formulations);
    campaign_.emplace(plan_from(plan, "test"), catalogue);
    store_.emplace(Store::create(folder_ / "runs.sqlite", campaign_->description()));
    make_runs(*campaign_, shard, *store_);
  }

  std::optional<Campaign> campaign_;
  std::optional<Store> store_;
};

}  // namespace ricochet::comparison
