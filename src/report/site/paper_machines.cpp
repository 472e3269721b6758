#include "src/report/site/paper_machines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>

namespace ricochet::site {

RICOCHET_FIELDS(PaperMachine, id, restitution, friction, disturbance, silent_up_to, quiet_up_to,
                paper_threshold);

namespace {

struct Agreement {
  std::int64_t thresholds;
  double error;
};
RICOCHET_FIELDS(Agreement, thresholds, error);

struct Fit {
  std::optional<std::int64_t> fitted;
};
RICOCHET_FIELDS(Fit, fitted);

constexpr double shown_to = 14;  ///< [rad/s], at least, of the chart
constexpr double half_column = 0.42;

/// The three constants, with their names.
using Constant = double PaperMachine::*;
constexpr std::pair<const char*, Constant> constants[] = {
    {"restitution", &PaperMachine::restitution},
    {"friction", &PaperMachine::friction},
    {"disturbance", &PaperMachine::disturbance}};

/// Returns true if the two differ in no constant but this one.
bool alike_except(const PaperMachine& a, const PaperMachine& b, Constant constant) {
  return std::ranges::all_of(constants, [&](const auto& one) {
    return one.second == constant || a.*one.second == b.*one.second;
  });
}

std::optional<ThresholdEffect> effect_of(const std::vector<PaperMachine>& machines,
                                         const char* name, Constant constant) {
  const auto [low, high] = std::ranges::minmax_element(machines, {}, constant);
  if (low == machines.end() || (*low).*constant == (*high).*constant) return std::nullopt;
  ThresholdEffect effect{name, (*low).*constant, (*high).*constant, HUGE_VAL, 0, 0};
  for (const PaperMachine& from : machines) {
    if (from.*constant != effect.from || !from.quiet_up_to) continue;
    for (const PaperMachine& to : machines) {
      if (to.*constant != effect.to || !to.quiet_up_to) continue;
      if (!alike_except(from, to, constant)) continue;
      const double ratio = *to.quiet_up_to / *from.quiet_up_to;
      effect.least = std::min(effect.least, ratio);
      effect.most = std::max(effect.most, ratio);
      ++effect.pairs;
    }
  }
  return effect.pairs > 0 ? std::optional(effect) : std::nullopt;
}

/// A column of the chart for each machine, between two speeds.
report::Area columns(const PaperMachines& all, std::string label, std::optional<double> shade,
                     const std::function<std::pair<double, double>(const PaperMachine&)>& ends) {
  report::Area area{std::move(label), shade, {}, {}};
  for (std::size_t i = 0; i < all.machines.size(); ++i) {
    const auto [lower, upper] = ends(all.machines[i]);
    if (upper <= lower) continue;
    const double at = static_cast<double>(i);
    area.parts.push_back({{at - half_column, {lower, upper}}, {at + half_column, {lower, upper}}});
  }
  return area;
}

/// "1.5 to 1.9", or one number if both are shown alike.
std::string extent_of(double least, double most, const char* form) {
  const std::string first = fmt::format(fmt::runtime(form), least);
  const std::string last = fmt::format(fmt::runtime(form), most);
  return first == last ? first : first + " to " + last;
}

constexpr double as_a_factor = 1.25;  ///< from here on a ratio is told as a factor

/// What the effect does to the threshold: "divides it by 3.4 to 4.5", "lowers it by 0.1 to 12 %".
std::string done_by(const ThresholdEffect& effect) {
  const double least = effect.least, most = effect.most;
  const auto percent = [](double ratio) { return 100 * std::abs(ratio - 1); };
  if (least >= as_a_factor) return "multiplies it by " + extent_of(least, most, "{:.1f}");
  if (most <= 1 / as_a_factor) return "divides it by " + extent_of(1 / most, 1 / least, "{:.1f}");
  if (most <= 1)
    return fmt::format("lowers it by {} %", extent_of(percent(most), percent(least), "{:.1f}"));
  if (least >= 1)
    return fmt::format("raises it by {} %", extent_of(percent(least), percent(most), "{:.1f}"));
  return fmt::format("changes it by -{:.1f} to +{:.1f} %", percent(least), percent(most));
}

}  // namespace

std::optional<PaperMachines> paper_machines(const std::vector<FoundReport>& reports) {
  for (const FoundReport& report : reports) {
    if (report.kind.name != "reproduction" || !report.headline) continue;
    if (!report.data.contains("cases") || !report.data.contains("interpretation")) continue;
    const auto agreement = report.data.at("agreement").get<Agreement>();
    PaperMachines all{report.folder,
                      {},
                      agreement.error,
                      agreement.thresholds,
                      report.data.at("interpretation").get<Fit>().fitted};
    for (const auto& [id, one] : report.data.at("cases").items()) {
      all.machines.push_back(one.get<PaperMachine>());
    }
    std::ranges::stable_sort(all.machines, [](const PaperMachine& a, const PaperMachine& b) {
      return std::tuple(a.restitution, -a.friction, a.disturbance) <
             std::tuple(b.restitution, -b.friction, b.disturbance);
    });
    return all;
  }
  return std::nullopt;
}

std::vector<ThresholdEffect> threshold_effects(const std::vector<PaperMachine>& machines) {
  std::vector<ThresholdEffect> effects;
  for (const auto& [name, constant] : constants) {
    if (const auto effect = effect_of(machines, name, constant)) effects.push_back(*effect);
  }
  return effects;
}

std::optional<std::pair<double, double>> quiet_range(const std::vector<PaperMachine>& machines) {
  std::optional<std::pair<double, double>> range;
  for (const PaperMachine& machine : machines) {
    if (!machine.quiet_up_to) continue;
    if (!range) range = {*machine.quiet_up_to, *machine.quiet_up_to};
    range->first = std::min(range->first, *machine.quiet_up_to);
    range->second = std::max(range->second, *machine.quiet_up_to);
  }
  return range;
}

report::Chart regimes_chart(const PaperMachines& all) {
  const auto range = quiet_range(all.machines);
  const double top = std::max(shown_to, range ? range->second + 1 : 0);
  report::Chart chart{
      .name = "regimes-of-the-machines",
      .title = "How fast the paper's machines are silent, quiet and loud",
      .x = {.label = ""},
      .y = {.label = "speed of the driver plate [rad/s]", .range = report::Range{0, top}},
      .width = 520,
      .height = 330};
  report::Series paper{
      .label = "the paper's threshold", .mark = report::Mark::points, .samples = {}, .dark = true};
  for (std::size_t i = 0; i < all.machines.size(); ++i) {
    const PaperMachine& machine = all.machines[i];
    chart.x.categories.push_back(machine.id);
    if (machine.paper_threshold) {
      paper.samples.push_back({static_cast<double>(i), machine.paper_threshold});
    }
  }
  const auto silent = [](const PaperMachine& m) { return m.silent_up_to.value_or(0); };
  const auto quiet = [&](const PaperMachine& m) {
    return std::max(m.quiet_up_to.value_or(0), silent(m));
  };
  chart.areas = {columns(all, "silent: no collision that counts", 1.0,
                         [&](const PaperMachine& m) { return std::pair(0.0, silent(m)); }),
                 columns(all, "quiet: at most two a turn", 0.72,
                         [&](const PaperMachine& m) { return std::pair(silent(m), quiet(m)); }),
                 columns(all, "loud: more", 0.12,
                         [&](const PaperMachine& m) { return std::pair(quiet(m), top); })};
  if (!paper.samples.empty()) chart.series.push_back(std::move(paper));
  chart.description =
      "Columns of the paper's machines over speed: silent, quiet and loud, with the paper's "
      "thresholds as points. " +
      speed_sentence(all);
  return chart;
}

std::string speed_sentence(const PaperMachines& all) {
  const auto range = quiet_range(all.machines);
  if (!range) return "No machine of the paper is quiet at any speed.";
  constexpr double rpm = 30 / std::numbers::pi;
  return fmt::format(
      "The paper's {} machines stay quiet up to {:.1f} to {:.1f} rad/s ({:.0f} to {:.0f} rpm): at "
      "most two collisions a turn, one with each wall.",
      all.machines.size(), range->first, range->second, range->first * rpm, range->second * rpm);
}

std::string effects_sentence(const PaperMachines& all) {
  std::string text;
  for (const ThresholdEffect& effect : threshold_effects(all.machines)) {
    text += fmt::format("{}{} from {} to {}{} {}", text.empty() ? "" : "; ", effect.constant,
                        effect.from, effect.to, effect.constant == "disturbance" ? " N" : "",
                        done_by(effect));
  }
  return text.empty() ? text : "The threshold: " + text + ".";
}

std::string groups_sentence(const PaperMachines& all) {
  std::string text;
  for (std::size_t i = 0; i < all.machines.size(); ++i) {
    const PaperMachine& one = all.machines[i];
    const bool same = i > 0 && one.restitution == all.machines[i - 1].restitution &&
                      one.friction == all.machines[i - 1].friction;
    const bool ends = i + 1 == all.machines.size() ||
                      one.restitution != all.machines[i + 1].restitution ||
                      one.friction != all.machines[i + 1].friction;
    text += (text.empty() ? "" : same ? ", " : "; ") + one.id;
    if (ends) text += fmt::format(": restitution {}, friction {}", one.restitution, one.friction);
  }
  return text + ". Within a group the disturbance differs.";
}

std::string agreement_sentence(const PaperMachines& all) {
  std::string text = fmt::format(
      "By the paper's own rule {} thresholds are {:.0f} % from the paper's (root-mean-square error "
      "in log speed)",
      all.compared, 100 * all.error);
  if (all.fitted) {
    text += fmt::format(", after fitting {} parameters to the same thresholds", *all.fitted);
  }
  return text + ".";
}

}  // namespace ricochet::site
