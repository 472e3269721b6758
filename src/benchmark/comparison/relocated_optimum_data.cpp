#include "src/benchmark/comparison/relocated_optimum_data.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

#include "src/benchmark/analysis/rating.h"
#include "src/benchmark/comparison/share_data.h"
#include "src/benchmark/experiment/campaign/relocated_optimum.h"
#include "src/benchmark/statistics/holm.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

constexpr std::array places = {"lower", "middle", "upper"};
using Shares = std::array<Share, places.size()>;  // by place of the optimum

/// Fisher's test of both ends against the middle.
double p_value_of(const Shares& shares) {
  const Share ends{shares[0].successes + shares[2].successes, shares[0].trials + shares[2].trials};
  return fisher_exact_test(ends, shares[1]);
}

void add_rows(Json& rows, const std::map<std::string, Shares>& entries) {
  std::vector<double> p_values;
  for (const auto& [entry, shares] : entries) p_values.push_back(p_value_of(shares));
  p_values = holm(p_values);
  auto p_value = p_values.begin();
  for (const auto& [entry, shares] : entries) {
    Json row = {{"solver", entry},
                {"runs", shares[0].trials},
                {"p_value", *p_value},
                {"leans", *p_value < 0.05}};
    for (std::size_t k = 0; k < places.size(); ++k) row[places[k]] = share_data(shares[k]);
    rows.push_back(std::move(row));
    ++p_value;
  }
}

}  // namespace

Json relocated_optimum_data(const Campaign& campaign, const std::vector<CellResult>& results) {
  Json rows = Json::array();
  Json parts = Json::array();
  for (std::size_t part = 0; part < campaign.plan().parts.size(); ++part) {
    if (!campaign.plan().parts[part].relocated_optimum) continue;
    std::map<std::string, Shares> entries;
    std::set<std::size_t> problems;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Comparison comparison =
          comparison_of(campaign, results, {.part = part, .perturbation = names_of_places()[k]});
      for (const CellResult& result : comparison.results) {
        const Cell& cell = result.cell->cell;
        add_runs(entries[entry(cell.solver, cell.formulation)][k], result);
        problems.insert(result.cell->problem);
      }
    }
    add_rows(rows, entries);
    Json variables = variables_of(campaign, {problems.begin(), problems.end()});
    variables["problems"] = problems.size();
    parts.push_back(std::move(variables));
  }
  Json biased = Json::array();
  for (const Json& row : rows) {
    if (row["leans"] == true) biased.push_back(row["solver"]);
  }
  return {{"relocated_optima", std::move(rows)},
          {"biased", std::move(biased)},
          {"relocated", std::move(parts)}};
}

}  // namespace ricochet::studies::comparison
