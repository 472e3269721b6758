#include "problems/carrier_track/advice/regime_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "problems/carrier_track/advice/answer_notes.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;
using report::Json;

constexpr double narrow = 1.01;        // ratio of the speeds at its ends
constexpr std::size_t summarised = 4;  // wide regimes

bool is_narrow(const Regime& regime) {
  return regime.to < narrow * regime.from;
}

std::string counts_of(const Regime& regime) {
  if (regime.least_per_turn == regime.most_per_turn) {
    return fmt::format("{:.4g}", regime.most_per_turn);
  }
  return fmt::format("{:.4g} to {:.4g}", regime.least_per_turn, regime.most_per_turn);
}

std::string line_of(const RegimeRow& row, bool marked) {
  const Regime& regime = row.regime;
  if (!regime.moves) {
    return fmt::format("{:>8.3f} {:>8.3f} {:>8.2f}  {:<12}{:>10}{:>10}{:>8}  {}{}\n", regime.from,
                       regime.to, regime.to * rpm, "0", "-", "-", "100 %", name_of(regime.ends_by),
                       marked ? "  <-" : "");
  }
  return fmt::format("{:>8.3f} {:>8.3f} {:>8.2f}  {:<12}{:>10.3g}{:>10.3g}{:>6.0f} %  {}{}{}\n",
                     regime.from, regime.to, regime.to * rpm, counts_of(regime),
                     1e3 * regime.last.energy_per_turn, 1e3 * regime.last.fastest_impact,
                     100 * regime.last.share_at_rest, name_of(regime.ends_by),
                     regime.certain ? "" : ", not periodic", marked ? "  <-" : "");
}

}  // namespace

std::vector<RegimeRow> rows_of(const std::vector<Regime>& regimes) {
  std::vector<RegimeRow> rows;
  for (const Regime& regime : regimes) {
    const bool joins = !rows.empty() && is_narrow(regime) && rows.back().regime.moves &&
                       (rows.back().merged > 1 || is_narrow(rows.back().regime));
    if (!joins) {
      rows.push_back({regime});
      continue;
    }
    Regime& row = rows.back().regime;
    const double width = row.to - row.from;
    const double added = regime.to - regime.from;
    row.collisions_per_turn =
        (width * row.collisions_per_turn + added * regime.collisions_per_turn) / (width + added);
    row.least_per_turn = std::min(row.least_per_turn, regime.least_per_turn);
    row.most_per_turn = std::max(row.most_per_turn, regime.most_per_turn);
    row.to = regime.to;
    row.last = regime.last;
    row.certain = row.certain && regime.certain;
    row.ends_by = regime.ends_by;
    ++rows.back().merged;
  }
  return rows;
}

std::string summary_of(const std::vector<Regime>& regimes) {
  std::vector<Regime> wide;
  for (const Regime& regime : regimes) {
    if (is_narrow(regime) && regime.ends_by != RegimeEnd::range) continue;
    const bool same = !wide.empty() && wide.back().most_per_turn == regime.most_per_turn;
    if (same) {
      wide.back().to = regime.to;
    } else {
      wide.push_back(regime);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < wide.size() && i < summarised; ++i) {
    const Regime& regime = wide[i];
    const bool last = i + 1 == wide.size() || i + 1 == summarised;
    text += fmt::format("{}{}", i == 0 ? "" : ", then ",
                        regime.most_per_turn == 0
                            ? std::string("silent")
                            : fmt::format("{} collisions a turn", counts_of(regime)));
    if (!last || wide.size() == 1) text += " up to " + both_units(regime.to);
  }
  return text + (wide.size() > summarised ? ", and more beyond" : "");
}

std::string text_of(const std::vector<Regime>& regimes, std::optional<double> marked) {
  std::string text = fmt::format("{:>8} {:>8} {:>8}  {:<12}{:>10}{:>10}{:>8}  {}\n", "from", "to",
                                 "to", "collisions", "energy", "fastest", "rest", "ends by");
  text += fmt::format("{:>8} {:>8} {:>8}  {:<12}{:>10}{:>10}{:>8}\n", "rad/s", "rad/s", "rpm",
                      "a turn", "mJ a turn", "mm/s", "");
  for (const RegimeRow& row : rows_of(regimes)) {
    text += line_of(row, marked && row.regime.from < *marked && *marked <= row.regime.to);
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

report::Chart regime_chart(const std::vector<Regime>& regimes, std::string title) {
  report::Chart chart;
  chart.name = "regimes";
  chart.title = std::move(title);
  chart.width = 960;
  chart.height = 400;
  report::Series mean{"collisions a turn", report::Mark::steps, {}};
  double most = 0;
  for (const Regime& regime : regimes) {
    mean.samples.push_back({regime.from, regime.collisions_per_turn});
    most = std::max(most, regime.most_per_turn);
  }
  mean.samples.push_back({regimes.back().to, regimes.back().collisions_per_turn});
  chart.series = {mean};
  chart.x = {.label = "speed [rad/s]", .range = report::Range{0, regimes.back().to}};
  chart.y = {.label = "collisions a turn", .range = report::Range{0, 1 + 1.1 * most}};
  return chart;
}

}  // namespace ricochet::studies::advice
