#include <algorithm>

#include "src/research/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using report::Json;

/// The mean counts at a disturbance, a row for each friction.
Json means_at(const CountGrid& grid, std::size_t disturbance) {
  Json rows = Json::array();
  for (std::size_t f = 0; f < grid.frictions.size(); ++f) {
    Json means = Json::array();
    for (std::size_t r = 0; r < grid.restitutions.size(); ++r) {
      means.push_back(grid.mean(r, f, disturbance));
    }
    rows.push_back({{"friction", grid.frictions[f]}, {"means", std::move(means)}});
  }
  return {{"number", disturbance + 1},
          {"disturbance", grid.disturbances[disturbance]},
          {"frictions", std::move(rows)}};
}

/// With the first few exceptions; all pairs that disagree are exceptions.
Json trend_data(const Trend& trend) {
  constexpr std::size_t shown = 4;
  std::vector<Reversal> first = trend.exceptions;
  if (first.size() > shown) first.resize(shown);
  return {{"conclusion", trend.conclusion},
          {"claim", trend.claim},
          {"agree", trend.agree},
          {"disagree", trend.disagree},
          {"changes", trend.agree + trend.disagree},
          {"weakest", trend.weakest},
          {"holds", trend.weakest > 1},
          {"strongest", trend.strongest},
          {"first_exceptions", std::move(first)},
          {"further_exceptions", trend.exceptions.size() > shown}};
}

}  // namespace

Json conclusion_data(const CountGrid& grid, const std::vector<Trend>& trends) {
  const auto [least, most] = std::minmax_element(grid.means.begin(), grid.means.end());
  Json data = {{"trends", report::list_of(trends, trend_data)},
               {"restitutions", grid.restitutions},
               {"least", *least},
               {"most", *most},
               {"grid", Json::array()}};
  for (std::size_t d = 0; d < grid.disturbances.size(); ++d) {
    data["grid"].push_back(means_at(grid, d));
  }
  return data;
}

}  // namespace ricochet::studies::reproduction
