#include "src/studies/machine/regime_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "ricochet/machine.h"
#include "src/studies/machine/answer.h"

namespace ricochet::carrier_track::inline regimes {

RICOCHET_FIELDS(MapPoint, constant, omega, slope);

}  // namespace ricochet::carrier_track::inline regimes

namespace ricochet::studies::advice {

namespace {

using namespace carrier_track;
using report::Json;

constexpr double narrow = 1.01;        // ratio of the speeds at its ends
constexpr double seen = 1.1;           // ratio at which a level is worth a mention
constexpr std::size_t summarised = 4;  // levels

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

namespace {

/// A range of speeds up to which no turn has more collisions.
struct Level {
  double from, to;  ///< [rad/s]
  double collisions;
};

std::vector<Level> levels_of(const std::vector<Regime>& regimes) {
  std::vector<Level> levels;
  for (const Regime& regime : regimes) {
    if (levels.empty() || regime.most_per_turn > levels.back().collisions) {
      levels.push_back({regime.from, regime.to, regime.most_per_turn});
    }
    levels.back().to = regime.to;
  }
  return levels;
}

}  // namespace

std::vector<Regime> without_narrow(const std::vector<Regime>& regimes) {
  std::vector<Regime> shown;
  for (std::size_t i = 0; i < regimes.size(); ++i) {
    const bool inner = i > 0 && i + 1 < regimes.size();
    if (!inner || !is_narrow(regimes[i])) shown.push_back(regimes[i]);
  }
  return shown;
}

std::string summary_of(const std::vector<Regime>& regimes) {
  std::vector<Level> levels;
  for (const Level& level : levels_of(regimes)) {
    // Narrow levels between others are part of one border to the eye, but for those that answer.
    const bool narrow = level.to < seen * level.from && level.to < regimes.back().to;
    const bool answers = level.collisions == 0 || level.collisions == quiet_per_turn;
    if (!narrow || answers) levels.push_back(level);
  }
  std::string text;
  for (std::size_t i = 0; i < levels.size() && i < summarised; ++i) {
    const std::string at_most =
        levels[i].collisions == 0
            ? "silent"
            : fmt::format("at most {:.4g} collision{} a turn", levels[i].collisions,
                          levels[i].collisions == 1 ? "" : "s");
    const bool last = i + 1 == levels.size();
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", at_most,
                        last && i > 0 ? "beyond" : "up to " + both_units(levels[i].to));
  }
  return text + (levels.size() > summarised ? ", and more beyond" : "");
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

/// Borders of the machine that are one to the eye; the first is shown.
struct Border {
  const MapCurve* curve;
  double slower, faster;  ///< collisions a turn before the first and beyond the last
  double last;            ///< [rad/s], of the last at the machine's own constant
};

std::vector<Border> borders_of(const RegimeMap& map) {
  std::vector<const MapCurve*> own;
  for (const MapCurve& curve : map.curves)
    if (curve.own) own.push_back(&curve);
  std::ranges::stable_sort(own, {}, [](const MapCurve* curve) { return *curve->own; });
  std::vector<Border> borders;
  for (const MapCurve* curve : own) {
    const bool joins = !borders.empty() && *curve->own < near_ratio * borders.back().last &&
                       borders.back().curve->kind == curve->kind;
    if (!joins) {
      borders.push_back({curve, curve->slower, curve->faster, *curve->own});
    } else {
      borders.back().faster = curve->faster;
      borders.back().last = *curve->own;
    }
  }
  return borders;
}

/// Some values of the constant, evenly spaced, at which the regimes are solved.
std::vector<double> values_of(const RegimeMap& map) {
  std::vector<double> values;
  for (int k = 0; k < shown_values; ++k) {
    const double wanted =
        map.options.from + (map.options.to - map.options.from) * k / (shown_values - 1);
    const auto nearest = std::ranges::min_element(map.columns, {}, [&](const MapColumn& column) {
      return std::abs(column.constant - wanted);
    });
    if (values.empty() || nearest->constant > values.back()) values.push_back(nearest->constant);
  }
  return values;
}

std::optional<double> speed_at(const MapCurve& curve, double constant) {
  const auto point = std::ranges::find(curve.points, constant, &MapPoint::constant);
  return point == curve.points.end() ? std::nullopt : std::optional(point->omega);
}

std::string words_for(CurveEnd end) {
  switch (end) {
    case CurveEnd::range:
      break;
    case CurveEnd::fold_back:
      return "it turns back";
    case CurveEnd::other_border:
      return "it meets another border";
    case CurveEnd::impact_missing:
      return "its impact ceases to exist";
    case CurveEnd::speeds:
      return "it leaves the range of speeds";
    case CurveEnd::other_motion:
      return "the carrier is on another motion beyond";
    case CurveEnd::not_sharp:
      return "it is not found at the next value";
    case CurveEnd::not_found:
      return "it is not found beyond";
  }
  return "";
}

std::string change_of_counts(double slower, double faster) {
  return slower == faster ? fmt::format("{:.4g}", slower)
                          : fmt::format("{:.4g} to {:.4g}", slower, faster);
}

/// "  2 to 4 collisions: up to 0.32, where it turns back\n"
std::string ends_of(const Border& border, const RegimeMap& map, const ShownUnit& unit) {
  const MapCurve& curve = *border.curve;
  std::string text;
  const auto add = [&](const char* side, const MapPoint& point, CurveEnd end) {
    if (end == CurveEnd::range) return;
    text += fmt::format("The border of {} collisions a turn ends at {} {} {:.4g}{}{}: {}.\n",
                        change_of_counts(border.slower, border.faster), side, map.options.constant,
                        point.constant / unit.size, unit.name.empty() ? "" : " ", unit.name,
                        words_for(end));
  };
  add("the lower", curve.points.front(), curve.begins);
  add("the upper", curve.points.back(), curve.ends);
  return text;
}

}  // namespace

std::string text_of(const RegimeMap& map, const ShownUnit& unit) {
  const std::vector<Border> borders = borders_of(map);
  const std::vector<double> values = values_of(map);
  Table table{"borders", {{"collisions", "collisions a turn"}, {"ends_by", "ends by"}}};
  for (const double value : values) {
    table.columns.push_back({fmt::format("{:.4g}", value / unit.size)});
  }
  for (const Border& border : borders) {
    std::vector<Value> row = {change_of_counts(border.slower, border.faster),
                              std::string(name_of(border.curve->kind))};
    for (const double value : values) row.push_back(value_of(speed_at(*border.curve, value)));
    table.add_row(std::move(row));
  }
  std::string text = fmt::format(
      "Their speeds [rad/s] at values of {}{}:\n{}", map.options.constant,
      unit.name.empty() ? "" : fmt::format(" [{}]", unit.name), terminal_text_of(table));
  for (const Border& border : borders) text += ends_of(border, map, unit);
  const auto others =
      std::ranges::count_if(map.curves, [](const MapCurve& curve) { return !curve.own; });
  if (others > 0) {
    text += fmt::format("{} border{} that the machine itself does not have: see --format json.\n",
                        others, others == 1 ? "" : "s");
  }
  return text;
}

Json json_of(const RegimeMap& map) {
  return {{"constant", map.options.constant},
          {"own", map.own},
          {"from", map.options.from},
          {"to", map.options.to},
          {"slowest", map.options.speeds.from},
          {"fastest", map.options.speeds.to},
          {"followed", map.followed},
          {"curves", report::list_of(map.curves, [](const MapCurve& curve) {
             return Json{{"kind", name_of(curve.kind)},
                         {"collisions_slower", curve.slower},
                         {"collisions_faster", curve.faster},
                         {"own", report::as_json(curve.own)},
                         {"begins", name_of(curve.begins)},
                         {"ends", name_of(curve.ends)},
                         {"points", report::as_json(curve.points)}};
           })}};
}

Table point_table(const RegimeMap& map) {
  Table table{"points",
              columns_named("curve,kind,collisions_slower,collisions_faster,constant,omega,slope")};
  for (std::size_t i = 0; i < map.curves.size(); ++i) {
    const MapCurve& curve = map.curves[i];
    for (const MapPoint& point : curve.points) {
      table.add(i + 1, name_of(curve.kind), curve.slower, curve.faster, point.constant, point.omega,
                point.slope);
    }
  }
  return table;
}

}  // namespace ricochet::studies::advice
