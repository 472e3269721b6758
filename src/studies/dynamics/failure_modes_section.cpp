#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/studies/dynamics/sections.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Alignment;
using report::Cell;
using report::State;

/// A number in a few characters: 0.03, 12, 3e-07.
std::string brief(double value) {
  const double size = std::abs(value);
  return size == 0 || (size >= 0.01 && size < 1000) ? fmt::format("{:.2g}", value)
                                                    : fmt::format("{:.0e}", value);
}

Cell words_of(const Zeno& zeno) {
  if (!zeno.finished) return {"gives up", State::bad};
  if (!zeno.rest) {
    return {fmt::format("never rests: still bounces {:.1f} s after the end", zeno.rest_late),
            State::bad};
  }
  const double late = zeno.rest_late;
  const bool right = std::abs(late) < 1e-3 * zeno.end_of_impacts;
  if (std::abs(late) < 1e-5) return {"rests in time", State::good};
  return {fmt::format("rests {} s {}", brief(std::abs(late)), late > 0 ? "late" : "early"),
          right ? State::good : State::bad};
}

/// The least overshoot from which on all shares are one; nothing if none is.
std::optional<double> all_right_from(const std::vector<double>& overshoots,
                                     const std::vector<double>& shares) {
  std::optional<double> least;
  for (std::size_t k = 0; k < shares.size() && shares[k] == 1; ++k) least = overshoots[k];
  return least;
}

Cell words_of_grazes(const MethodHazards& hazards, const std::vector<double>& overshoots) {
  const auto sees = all_right_from(overshoots, hazards.touched);
  const auto spares = all_right_from(overshoots, hazards.missed);
  const bool all = sees == overshoots.back() && spares == overshoots.back();
  if (all) return {"sees all, invents none", State::good};
  std::string text = !sees                        ? "misses some at any depth"
                     : *sees == overshoots.back() ? "sees all"
                                                  : fmt::format("sees all from {:.0e}", *sees);
  text += !spares                        ? ", invents some at any distance"
          : *spares == overshoots.back() ? ", invents none"
                                         : fmt::format(", invents none from {:.0e}", *spares);
  return {text, State::bad};
}

Cell words_of(const Sticking& sticking, int decades) {
  if (sticking.gave_up) {
    return {fmt::format("gives up at an excess of {:.0e}", *sticking.gave_up), State::bad};
  }
  const double least = std::pow(10.0, -decades);
  const bool all = sticking.noticed && *sticking.noticed < 1.5 * least;
  std::string text = sticking.creep > 0 ? fmt::format("creeps {} m/s; ", brief(sticking.creep))
                                        : std::string("holds; ");
  text += !sticking.noticed ? "misses any brief excess"
          : all             ? "breaks loose in time"
                            : fmt::format("misses an excess below {:.0e}", *sticking.noticed);
  if (sticking.breaks_loose_early) text += ", breaks loose too early";
  return {text,
          all && sticking.creep == 0 && !sticking.breaks_loose_early ? State::good : State::bad};
}

Cell words_of(const Elastic& elastic) {
  if (elastic.seen == 0) return {"no impact", State::bad};
  const double drift = elastic.energy_ratio - 1;
  std::string text =
      elastic.energy_ratio < 0.01 ? "loses all energy"
      : elastic.energy_ratio > 2  ? fmt::format("{:.0f} times the energy", elastic.energy_ratio)
      : std::abs(drift) < 1e-8
          ? "keeps it to 1e-8"
          : fmt::format("{} {} %", drift > 0 ? "gains" : "loses", brief(100 * std::abs(drift)));
  if (elastic.seen < elastic.impacts) {
    text += fmt::format(", sees {} of {} impacts", elastic.seen, elastic.impacts);
  }
  return {text,
          std::abs(drift) < 1e-3 && elastic.seen == elastic.impacts ? State::good : State::bad};
}

Cell words_of(const ChaoticRate& rate) {
  if (!rate.finished) return {"gives up", State::bad};
  const bool right = std::abs(rate.error) <= rate.uncertainty;
  return {fmt::format("{:+.1f} %", 100 * rate.error), right ? State::good : State::bad};
}

report::Table table_of(const FailureModeStudy& study, const std::vector<MethodHazards>& methods,
                       const std::string& controls) {
  report::Table table{controls,
                      {{"method", Alignment::left},
                       {"endless bouncing", Alignment::left},
                       {"wall just touched or missed", Alignment::left},
                       {"sticking", Alignment::left}},
                      {}};
  for (const double loss : study.losses) {
    table.columns.push_back({fmt::format("energy, restitution 1 - {:.0e}", loss), Alignment::left});
  }
  table.columns.push_back({"chaos: impacts a second", Alignment::left});
  for (const MethodHazards& method : methods) {
    std::vector<Cell> row = {{method.method},
                             words_of(method.zeno),
                             words_of_grazes(method, study.overshoots),
                             words_of(method.sticking, study.plan.decades)};
    for (const Elastic& elastic : method.elastic) row.push_back(words_of(elastic));
    row.push_back(words_of(method.rate));
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Figure map_of(const FailureModeStudy& study, const std::vector<MethodHazards>& methods,
                      const std::string& strictness) {
  report::Chart chart;
  chart.name = "hazards-grazing-" + strictness;
  chart.title = fmt::format("Is a touch seen, and only a touch? With {} control", strictness);
  chart.x.label = "wall missed by (-) or overshot by (+), in swings";
  chart.y.label = "method";
  for (const double by : study.overshoots) {
    chart.x.categories.push_back(fmt::format("-1e{:.0f}", std::log10(by)));
  }
  for (auto by = study.overshoots.rbegin(); by != study.overshoots.rend(); ++by) {
    chart.x.categories.push_back(fmt::format("+1e{:.0f}", std::log10(*by)));
  }
  report::HeatMap map{"right [%]", {}, report::Range{0, 100}};
  for (auto method = methods.rbegin(); method != methods.rend(); ++method) {
    chart.y.categories.push_back(method->method);
    auto& row = map.rows.emplace_back();
    for (const double share : method->missed) row.push_back(std::round(100 * share));
    for (auto share = method->touched.rbegin(); share != method->touched.rend(); ++share) {
      row.push_back(std::round(100 * *share));
    }
  }
  chart.heat_map = std::move(map);
  chart.width = 900;
  chart.height = 340;
  return {
      chart,
      strictness == "loose"
          ? "A body swings up to a wall. Left half: the wall is just out of reach, and an impact "
            "would be invented; right half: it is just reached, and an impact can be missed. "
            "100: right from whatever angle the swing starts."
          : "The same with tight control."};
}

/// How many of a table's judgements are bad, by method.
int failures(const std::vector<Cell>& row) {
  return static_cast<int>(std::count_if(row.begin(), row.end(),
                                        [](const Cell& cell) { return cell.state == State::bad; }));
}

/// How many methods fail at the hazard of a column.
int failing(const report::Table& table, std::size_t column) {
  return static_cast<int>(std::count_if(table.rows.begin(), table.rows.end(), [&](const auto& row) {
    return row[column].state == State::bad;
  }));
}

std::string finding(const report::Table& loose, const report::Table& tight) {
  const std::size_t hazards = tight.columns.size() - 1;
  std::string clean;
  int worst = -1;
  std::string worst_method;
  for (std::size_t m = 0; m < tight.rows.size(); ++m) {
    const int failed = failures(tight.rows[m]);
    if (failed + failures(loose.rows[m]) == 0) {
      clean += (clean.empty() ? "" : ", ") + tight.rows[m][0].text;
    }
    if (failed > worst) {
      worst = failed;
      worst_method = tight.rows[m][0].text;
    }
  }
  return fmt::format(
      "Found: {} passes all {} hazards at either control; at the tight control {} fails most, {} "
      "of {}. There a wall that is just touched or missed defeats {} of {} methods, sticking {}, "
      "endless bouncing {}; the rate of impacts in chaos, {}.",
      clean.empty() ? "no method" : clean, hazards, worst_method, worst, hazards, failing(tight, 2),
      tight.rows.size(), failing(tight, 3), failing(tight, 1), failing(tight, hazards));
}

}  // namespace

report::Section failure_modes_section(const FailureModeStudy& study) {
  report::Section section{"hazards", "Where methods fail: touches, rests, endless bouncing"};
  report::Table loose = table_of(
      study, study.loose, "Loose control: relative tolerance 1e-4, or 30 steps a swing or a hop.");
  report::Table tight =
      table_of(study, study.tight,
               "Tight control: relative tolerance 1e-10, or 1000 steps a swing or a hop.");
  const FailureModePlan& plan = study.plan;
  const ChaoticRate& rate = study.tight.front().rate;
  section.paragraphs = {
      finding(loose, tight),
      fmt::format(
          "Endless bouncing: a ball dropped from 50 m, restitution 0.8, has infinitely many "
          "impacts "
          "in {:.4f} s and then lies still; a good method rests within a thousandth of that time. "
          "Wall just touched or missed: a swing overshoots a wall by a part of itself, or falls "
          "short, by 1e-3 down to 1e-15; \"sees all from 1e-05\" means every touch at least that "
          "deep. Sticking: dry friction must hold a block that 0.9999 of it pushes at, and let it "
          "go when a varying force exceeds it for a moment, by 1e-1 down to {:.0e}.",
          study.tight.front().zeno.end_of_impacts, std::pow(10.0, -plan.decades)),
      fmt::format(
          "Energy: a ball that loses next to nothing in an impact has restitution^(2n) of its "
          "energy after n "
          "impacts; n is {}. Its flights are parabolas, which one-step methods of higher order "
          "follow exactly. A good method is right within 0.1 %. Chaos: impacts per second in the "
          "chaotic scene, {} runs of {:g} s, against 64 exact ones; within {:.1f} % nobody can "
          "tell.",
          plan.impacts, plan.starts, plan.seconds, 100 * rate.uncertainty)};
  section.tables = {std::move(loose), std::move(tight)};
  section.figures = {map_of(study, study.loose, "loose"), map_of(study, study.tight, "tight")};
  return section;
}

}  // namespace ricochet::studies::dynamics
