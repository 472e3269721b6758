#include <algorithm>
#include <cmath>

#include "problems/carrier_track/gradients/trust.h"
#include "src/studies/surrogate/grazes.h"

namespace ricochet::studies::surrogate {
namespace {

using carrier_track::short_reach;
using report::Json;

/// The slopes that are not zero, at one width: of the first graze of each case that something
/// follows, and where the wall is missed, of all of these.
Json slopes_of(const GrazeStudy& study, std::size_t width) {
  Json hits = Json::array(), missed = Json::array();
  const auto add = [](const Approach& at, double slope, Json& rows) {
    if (slope != 0) rows.push_back({{"distance", at.distance}, {"slope", std::abs(slope)}});
  };
  std::string shown;
  for (const GrazeRow& row : study.rows) {
    if (!row.followed() || row.id == shown) continue;
    shown = row.id;
    Json hit = Json::array();
    for (const Approach& at : row.approaches[width]) {
      add(at, at.hit_slope, hit);
      add(at, at.missed_slope, missed);
    }
    hits.push_back({{"id", row.id}, {"omega", row.graze.omega}, {"slopes", std::move(hit)}});
  }
  return {{"number", width + 1},
          {"smoothing", study.plan.widths[width]},
          {"hits", std::move(hits)},
          {"missed", std::move(missed)}};
}

Json reaches_of(const GrazeStudy& study) {
  Json reaches = Json::array();
  for (const GrazeRow& row : study.rows) {
    for (const Approach& at : row.approaches.front()) {
      reaches.push_back(
          {{"distance", at.distance}, {"hit", at.hit_reach}, {"missed", at.missed_reach}});
    }
  }
  return reaches;
}

Json data_of(const GrazeRow& row) {
  Json exponents = Json::array();
  for (const auto& exponent : row.exponents) exponents.push_back(exponent);
  const Approach& nearest = row.approaches.front().back();
  return {{"id", row.id},
          {"omega", row.graze.omega},
          {"wall", row.graze.wall == carrier_track::Wall::upper ? "upper" : "lower"},
          {"hit", row.graze.side > 0 ? "above" : "below"},
          {"exponents", std::move(exponents)},
          {"reach_hit", nearest.hit_reach / nearest.distance},
          {"reach_missed", nearest.missed_reach / nearest.distance}};
}

}  // namespace

Json data_of(const GrazeStudy& study) {
  Json rows = Json::array();
  std::size_t followed = 0;
  double least = 0;
  double most = -1e300;
  double steepest = 0;
  double missed = 0;
  double reach_error = 0;  // from 1e-6 of the range on
  for (const GrazeRow& row : study.rows) {
    rows.push_back(data_of(row));
    for (const Approach& a : row.approaches.front()) {
      if (a.distance > 1.01e-6) continue;
      reach_error = std::max({reach_error, std::abs(a.hit_reach / a.distance - 1),
                              std::abs(a.missed_reach / a.distance - 1)});
    }
    if (!row.followed()) continue;
    ++followed;
    for (const auto& exponent : row.exponents) {
      least = std::min(least, exponent.value_or(least));
      most = std::max(most, exponent.value_or(most));
    }
    for (const auto& approaches : row.approaches) {
      steepest = std::max(steepest, std::abs(approaches.back().hit_slope));
      missed = std::max(missed, std::abs(approaches.back().missed_slope));
    }
  }
  if (followed == 0) return nullptr;
  Json slopes = Json::array();
  for (std::size_t w = 0; w < study.plan.widths.size(); ++w) slopes.push_back(slopes_of(study, w));
  return {{"right", std::abs(least + 0.5) < 0.05 && std::abs(most + 0.5) < 0.05},
          {"followed", followed},
          {"all", rows.size()},
          {"least", least},
          {"most", most},
          {"narrowest", study.plan.widths.back()},
          {"widest", study.plan.widths.front()},
          {"nearest", study.plan.distances.back()},
          {"farthest", study.plan.distances.front()},
          {"steepest", steepest},
          {"missed", missed},
          {"reach_error", reach_error},
          {"short_reach", short_reach},
          {"widths", study.plan.widths},
          {"rows", std::move(rows)},
          {"slopes", std::move(slopes)},
          {"reaches", reaches_of(study)}};
}

}  // namespace ricochet::studies::surrogate
