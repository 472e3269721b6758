#include "src/studies/machine/regime_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "ricochet/machine.h"
#include "src/studies/machine/answer.h"

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

std::string line_of(const Regime& regime, bool marked) {
  if (!regime.moves) {
    return fmt::format("{:>8.3f} {:>8.3f} {:>8.2f}  {:<12}{:>10}{:>10}{:>8}  {}{}\n", regime.from,
                       regime.to, regime.to * rpm, "0", "-", "-", "100 %", name_of(regime.ends_by),
                       marked ? "  <-" : "");
  }
  return fmt::format("{:>8.3f} {:>8.3f} {:>8.2f}  {:<12}{:>10.3g}{:>10.3g}{:>6.0f} %  {}{}{}\n",
                     regime.from, regime.to, regime.to * rpm, counts_of(regime),
                     1e3 * regime.last.energy_per_turn, 1e3 * regime.last.fastest_impact,
                     100 * regime.last.share_at_rest, name_of(regime.ends_by),
                     regime.certain      ? ""
                     : regime.turns == 0 ? ", not periodic"
                                         : ", not certain",
                     marked ? "  <-" : "");
}

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

std::string text_of(const std::vector<Regime>& regimes, std::optional<double> marked) {
  std::string text = fmt::format("{:>8} {:>8} {:>8}  {:<12}{:>10}{:>10}{:>8}  {}\n", "from", "to",
                                 "to", "collisions", "energy", "fastest", "rest", "ends by");
  text += fmt::format("{:>8} {:>8} {:>8}  {:<12}{:>10}{:>10}{:>8}\n", "rad/s", "rad/s", "rpm",
                      "a turn", "mJ a turn", "mm/s", "");
  for (const Regime& regime : without_narrow(regimes)) {
    text += line_of(regime, marked && regime.from < *marked && *marked <= regime.to);
  }
  return text;
}

Json json_of(const std::vector<Regime>& regimes) {
  return report::list_of(regimes, [](const Regime& regime) {
    return Json{{"from", regime.from},
                {"to", regime.to},
                {"collisions_per_turn", regime.collisions_per_turn},
                {"least_per_turn", regime.least_per_turn},
                {"most_per_turn", regime.most_per_turn},
                {"energy_per_turn", regime.last.energy_per_turn},
                {"fastest_impact", regime.last.fastest_impact},
                {"share_at_rest", regime.last.share_at_rest},
                {"rests", regime.rests},
                {"moves", regime.moves},
                {"turns", regime.turns},
                {"memory", regime.memory},
                {"certain", regime.certain},
                {"ends_by", name_of(regime.ends_by)}};
  });
}

std::string text_of(const std::vector<SampledTurns>& sampled) {
  if (sampled.empty()) return "";
  std::string text = fmt::format(
      "By simulation alone, not certain ({} turns at each speed, after as many to settle; under a "
      "disturbance from {} of its phases):\n{:>8} {:>8}  collisions a turn\n{:>8} {:>8}  "
      "{:<10}most\n",
      sampled_turns_each, sampled_phases, "speed", "speed", "rad/s", "rpm", "mean");
  for (const SampledTurns& turns : sampled) {
    text += fmt::format("{:>8.3f} {:>8.2f}  {:<10.4g}{}\n", turns.omega, turns.omega * rpm,
                        turns.mean_per_turn, turns.most_per_turn);
  }
  return text;
}

Json json_of(const std::vector<SampledTurns>& sampled) {
  return report::list_of(sampled, [](const SampledTurns& turns) {
    return Json{{"omega", turns.omega},
                {"mean_per_turn", turns.mean_per_turn},
                {"most_per_turn", turns.most_per_turn}};
  });
}

namespace {

constexpr int shown_values = 7;
constexpr double near_ratio = 1.01;  // ratio of speeds of borders that are one to the eye

/// Borders of the machine that are one to the eye; the first is shown.
struct Row {
  const MapCurve* curve;
  double slower, faster;  ///< collisions a turn before the first and beyond the last
  double last;            ///< [rad/s], of the last at the machine's own constant
};

std::vector<Row> rows_of(const RegimeMap& map) {
  std::vector<const MapCurve*> own;
  for (const MapCurve& curve : map.curves)
    if (curve.own) own.push_back(&curve);
  std::ranges::stable_sort(own, {}, [](const MapCurve* curve) { return *curve->own; });
  std::vector<Row> rows;
  for (const MapCurve* curve : own) {
    const bool joins = !rows.empty() && *curve->own < near_ratio * rows.back().last &&
                       rows.back().curve->kind == curve->kind;
    if (!joins) {
      rows.push_back({curve, curve->slower, curve->faster, *curve->own});
    } else {
      rows.back().faster = curve->faster;
      rows.back().last = *curve->own;
    }
  }
  return rows;
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

std::string speed_at(const MapCurve& curve, double constant) {
  const auto point = std::ranges::find(curve.points, constant, &MapPoint::constant);
  return point == curve.points.end() ? "-" : fmt::format("{:.4g}", point->omega);
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
std::string ends_of(const Row& row, const RegimeMap& map, const ShownUnit& unit) {
  const MapCurve& curve = *row.curve;
  std::string text;
  const auto add = [&](const char* side, const MapPoint& point, CurveEnd end) {
    if (end == CurveEnd::range) return;
    text += fmt::format("The border of {} collisions a turn ends at {} {} {:.4g}{}{}: {}.\n",
                        change_of_counts(row.slower, row.faster), side, map.options.constant,
                        point.constant / unit.size, unit.name.empty() ? "" : " ", unit.name,
                        words_for(end));
  };
  add("the lower", curve.points.front(), curve.begins);
  add("the upper", curve.points.back(), curve.ends);
  return text;
}

}  // namespace

std::string text_of(const RegimeMap& map, const ShownUnit& unit) {
  const std::vector<Row> rows = rows_of(map);
  const std::vector<double> values = values_of(map);
  const std::string in = unit.name.empty() ? "" : fmt::format(" [{}]", unit.name);
  std::string text = fmt::format("{:<12}{:<16}speed [rad/s] at {}{}\n", "collisions", "ends by",
                                 map.options.constant, in);
  text += fmt::format("{:<28}", "a turn");
  for (const double value : values) text += fmt::format("{:>9.4g}", value / unit.size);
  text += "\n";
  for (const Row& row : rows) {
    text += fmt::format("{:<12}{:<16}", change_of_counts(row.slower, row.faster),
                        name_of(row.curve->kind));
    for (const double value : values) text += fmt::format("{:>9}", speed_at(*row.curve, value));
    text += "\n";
  }
  for (const Row& row : rows) text += ends_of(row, map, unit);
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
                         {"points", report::list_of(curve.points, [](const MapPoint& point) {
                            return Json{{"constant", point.constant},
                                        {"omega", point.omega},
                                        {"slope", report::as_json(point.slope)}};
                          })}};
           })}};
}

std::string csv_of(const RegimeMap& map) {
  std::string text = "curve,kind,collisions_slower,collisions_faster,constant,omega,slope\n";
  for (std::size_t i = 0; i < map.curves.size(); ++i) {
    const MapCurve& curve = map.curves[i];
    for (const MapPoint& point : curve.points) {
      text += fmt::format("{},{},{},{},{},{},{}\n", i + 1, name_of(curve.kind), curve.slower,
                          curve.faster, point.constant, point.omega,
                          point.slope ? fmt::format("{}", *point.slope) : "");
    }
  }
  return text;
}

}  // namespace ricochet::studies::advice
