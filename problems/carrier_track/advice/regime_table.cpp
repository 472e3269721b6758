#include "problems/carrier_track/advice/regime_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "problems/carrier_track/advice/answer_notes.h"
#include "ricochet/threshold.h"

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

}  // namespace ricochet::studies::advice
