#include "src/report/site/paper_machines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "src/report/results.h"

namespace ricochet::site {

namespace {

constexpr double shown_to = 14;  ///< [rad/s], at least, of the chart
constexpr double half_column = 0.42;

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

std::optional<double> number_of(const report::Results& results, const char* name) {
  const Value* value = results.value(name);
  return value == nullptr ? std::nullopt : number_in(*value);
}

}  // namespace

std::optional<PaperMachines> paper_machines(const std::vector<FoundReport>& reports) {
  for (const FoundReport& report : reports) {
    if (report.kind.name != "reproduction" || !report.headline) continue;
    const report::Results results = report::results_of(report.data);
    const ricochet::Table* cases = results.table("thresholds");
    if (cases == nullptr) continue;
    PaperMachines all{report.folder, {}, number_of(results, "error").value_or(0), 0, {}, "", {}};
    all.compared = static_cast<std::int64_t>(number_of(results, "compared").value_or(0));
    if (const auto fitted = number_of(results, "fitted"))
      all.fitted = static_cast<std::int64_t>(*fitted);
    for (const char* name : {"moves", "from_end_to_end"}) {
      const Value* text = results.value(name);
      if (text != nullptr && !is_missing(*text))
        all.moves += (all.moves.empty() ? "" : " ") + ricochet::text_of(*text);
    }
    for (const char* name : {"threshold-over-counting-limit", "threshold-over-clearance",
                             "threshold-over-restitution"}) {
      if (const report::Chart* chart = results.chart(name)) all.charts.push_back(*chart);
    }
    each_row(*cases, [&](const Row& row) {
      all.machines.push_back({row.text("case"), row.number("restitution"), row.number("friction"),
                              row.number("disturbance"), row.number_if("silent_up_to"),
                              row.number_if("quiet_up_to"), row.number_if("paper_threshold")});
    });
    std::ranges::stable_sort(all.machines, [](const PaperMachine& a, const PaperMachine& b) {
      return std::tuple(a.restitution, -a.friction, a.disturbance) <
             std::tuple(b.restitution, -b.friction, b.disturbance);
    });
    return all;
  }
  return std::nullopt;
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
  return fmt::format(
      "The paper's {} machines stay quiet up to {:.1f} to {:.1f} rad/s ({:.0f} to {:.0f} rpm): at "
      "most two collisions a turn, one with each wall.",
      all.machines.size(), range->first, range->second, range->first * rpm, range->second * rpm);
}

std::string effects_sentence(const PaperMachines& all) {
  return all.moves;
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
