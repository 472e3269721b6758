#include "src/studies/machine/regime_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "ricochet/machine.h"
#include "src/studies/machine/answer.h"

namespace ricochet::carrier_track::inline regimes {

RICOCHET_FIELDS(MapPoint, constant, omega, slope);
RICOCHET_FIELDS(MapColumn, value, cells);

}  // namespace ricochet::carrier_track::inline regimes

namespace ricochet::studies::advice {

namespace {

using namespace carrier_track;
using report::Json;

constexpr double narrow = 1.01;  // ratio of the speeds at its ends

bool is_narrow(const Regime& regime) {
  return regime.to < narrow * regime.from;
}

}  // namespace

std::string counts_of(const Regime& regime) {
  if (regime.least_per_turn == regime.most_per_turn) {
    return fmt::format("{:.4g}", regime.most_per_turn);
  }
  return fmt::format("{:.4g} to {:.4g}", regime.least_per_turn, regime.most_per_turn);
}

std::vector<Regime> without_narrow(const std::vector<Regime>& regimes) {
  std::vector<Regime> shown;
  for (std::size_t i = 0; i < regimes.size(); ++i) {
    const bool inner = i > 0 && i + 1 < regimes.size();
    if (!inner || !is_narrow(regimes[i])) shown.push_back(regimes[i]);
  }
  return shown;
}

std::string summary_of(const std::vector<Regime>& regimes) {
  std::string text;
  double last = 0;
  for (const auto& [at_most, words] :
       {std::pair(0.0, "silent"), std::pair(quiet_per_turn, "at most 2 collisions a turn")}) {
    const auto louder = std::ranges::find_if(
        regimes, [most = at_most](const Regime& regime) { return regime.most_per_turn > most; });
    const double to = louder == regimes.end() ? regimes.back().to : louder->from;
    if (louder != regimes.begin() && to > last)
      text += fmt::format("{}{} up to {}", text.empty() ? "" : ", ", words, both_units(to));
    if (louder == regimes.end()) return text;
    last = to;
  }
  return text.empty() ? "more than 2 collisions a turn" : text + ", more beyond";
}

Table regime_table(const std::vector<Regime>& regimes) {
  Table table{"regimes",
              {{"from", "from [rad/s]", ".3f"},
               {"to", "to [rad/s]", ".3f"},
               {"collisions_per_turn"},
               {"least_per_turn"},
               {"most_per_turn"},
               {"energy_per_turn", "energy a turn [mJ]", ".3gm"},
               {"fastest_impact", "fastest impact [mm/s]", ".3gm"},
               {"share_at_rest", "at rest [%]", ".0%"},
               {"rests"},
               {"moves"},
               {"turns"},
               {"memory"},
               {"certain", "", "mark"},
               {"ends_by", "ends by"},
               {"to_rpm", "to [rpm]", ".2f"},
               {"collisions", "collisions a turn"}}};
  for (const Regime& regime : regimes) {
    const LongRun& last = regime.last;
    table.add(regime.from, regime.to, regime.collisions_per_turn, regime.least_per_turn,
              regime.most_per_turn, last.energy_per_turn, last.fastest_impact, last.share_at_rest,
              regime.rests, regime.moves, regime.turns, regime.memory, regime.certain,
              name_of(regime.ends_by), regime.to * rpm, counts_of(regime));
  }
  return table;
}

Table shown_regimes(const std::vector<Regime>& regimes) {
  return only(regime_table(without_narrow(regimes)),
              {"from", "to", "to_rpm", "collisions", "energy_per_turn", "fastest_impact",
               "share_at_rest", "ends_by", "certain"});
}

Table sampled_table(const std::vector<SampledTurns>& sampled) {
  Table table{"sampled",
              {{"omega", "speed [rad/s]", ".3f"},
               {"rpm", "speed [rpm]", ".2f"},
               {"mean_per_turn", "mean collisions a turn"},
               {"most_per_turn", "most"}}};
  for (const SampledTurns& turns : sampled) {
    table.add(turns.omega, turns.omega * rpm, turns.mean_per_turn, turns.most_per_turn);
  }
  return table;
}

std::string text_of(const std::vector<SampledTurns>& sampled) {
  if (sampled.empty()) return "";
  return fmt::format(
             "By simulation alone, not certain ({} turns at each speed, after as many to settle; "
             "under a disturbance from {} of its phases):\n",
             sampled_turns_each, sampled_phases) +
         terminal_text_of(sampled_table(sampled));
}

namespace {

constexpr int shown_values = 7;
constexpr double near_ratio = 1.01;  // ratio of speeds of borders that are one to the eye

/// Curves without those that are one with the curve before to the eye: that one leads to what is
/// beyond.
std::vector<MapCurve> seen_curves(const RegimeMap& map) {
  std::vector<MapCurve> seen;
  double last = 0;
  for (const MapCurve& curve : map.curves) {
    const bool joins = curve.own && !seen.empty() && *curve.own < near_ratio * last &&
                       curve.kind == seen.back().kind;
    if (!joins) {
      seen.push_back(curve);
    } else {
      seen.back().faster = curve.faster;
    }
    last = curve.own.value_or(0);
  }
  return seen;
}

}  // namespace

std::string text_of(const RegimeMap& map, const MapUnits& units) {
  const auto& [over, values, against] = map.options;
  Table table{"borders", {{"collisions", "collisions a turn"}}};
  if (map.followed) table.columns.push_back({"ends_by", "ends by"});
  std::set<double> shown;
  for (int k = 0; k < shown_values; ++k) {
    const auto place = std::lround(k * (values - 1.0) / (shown_values - 1));
    shown.insert(map.columns[static_cast<std::size_t>(place)].value);
  }
  for (const double value : shown)
    table.columns.push_back({fmt::format("{:.4g}", value / units.over.size)});
  if (map.followed) {
    table.columns.push_back({"begins", "first point"});
    table.columns.push_back({"ends", "last point"});
  }
  for (const MapCurve& curve : seen_curves(map)) {
    std::vector<Value> row = {curve.slower == curve.faster
                                  ? fmt::format("{:.4g}", curve.slower)
                                  : fmt::format("{:.4g} to {:.4g}", curve.slower, curve.faster)};
    if (map.followed) row.push_back(name_of(*curve.kind));
    for (const double value : shown) {
      const auto point = std::ranges::find(curve.points, value, &MapPoint::constant);
      row.push_back(point == curve.points.end() ? Value()
                                                : value_of(point->omega / units.against.size));
    }
    if (map.followed) {
      row.push_back(name_of(curve.begins));
      row.push_back(name_of(curve.ends));
    }
    table.add_row(std::move(row));
  }
  const auto in = [](const ShownUnit& unit) {
    return unit.name.empty() ? "" : fmt::format(" [{}]", unit.name);
  };
  const std::string what =
      map.followed ? "Their speeds [rad/s]"
                   : fmt::format("The lowest {}{} at which the collisions change so, to {:.2g},",
                                 against.key == "omega" ? "speed" : against.key, in(units.against),
                                 (map.heights[1] - map.heights[0]) / 2 / units.against.size);
  return fmt::format("{} at values of {}{}:\n{}", what, over.key, in(units.over),
                     terminal_text_of(table));
}

Json json_of(const RegimeMap& map) {
  const auto& [over, values, against] = map.options;
  return {{"constant", over.key},
          {"own", map.own},
          {"from", over.from},
          {"to", over.to},
          {"against", against.key},
          {"slowest", against.from},
          {"fastest", against.to},
          {"followed", map.followed},
          {"complete", map.complete},
          {"curves",
           report::list_of(map.curves,
                           [](const MapCurve& curve) {
                             return Json{{"kind", curve.kind ? Json(name_of(*curve.kind)) : Json()},
                                         {"collisions_slower", curve.slower},
                                         {"collisions_faster", curve.faster},
                                         {"own", report::as_json(curve.own)},
                                         {"begins", name_of(curve.begins)},
                                         {"ends", name_of(curve.ends)},
                                         {"points", report::as_json(curve.points)}};
                           })},
          {"heights", map.heights},
          {"columns", report::as_json(map.columns)}};
}

Table point_table(const RegimeMap& map) {
  Table table{"points",
              columns_named("curve,kind,collisions_slower,collisions_faster,constant,omega,slope")};
  for (std::size_t i = 0; i < map.curves.size(); ++i) {
    const MapCurve& curve = map.curves[i];
    const Value kind = curve.kind ? Value(name_of(*curve.kind)) : Value();
    for (const MapPoint& point : curve.points) {
      table.add(i + 1, kind, curve.slower, curve.faster, point.constant, point.omega, point.slope);
    }
  }
  return table;
}

}  // namespace ricochet::studies::advice
