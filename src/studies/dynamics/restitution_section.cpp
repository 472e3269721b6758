#include <fmt/format.h>

#include <cmath>

#include "src/studies/dynamics/sections.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Alignment;
using report::Mark;

report::Figure chart_of(const std::vector<LawStudy>& laws) {
  report::Chart chart;
  chart.name = "restitution";
  chart.title = "Restitution asked for and returned";
  chart.x = {"restitution asked for", report::Scale::linear, report::Range{0, 1}};
  chart.y = {"restitution returned", report::Scale::linear, report::Range{0, 1.02}};
  chart.series = {{"as asked for", Mark::line, {{0, 0.0}, {1, 1.0}}}};
  for (const LawStudy& law : laws) {
    report::Series line{law.name, Mark::line, {}};
    for (const auto& point : law.exact) line.samples.push_back({point.asked, point.returned});
    chart.series.push_back(std::move(line));
  }
  report::Series points{"simulated impacts, every law", Mark::points, {}};
  for (const LawStudy& law : laws) {
    for (const auto& point : law.measured) points.samples.push_back({point.asked, point.returned});
  }
  chart.series.push_back(std::move(points));
  chart.width = 780;
  chart.height = 460;
  return {chart,
          "Lines: the closed relation between damping and restitution. Points: what simulated "
          "impacts on a compliant wall return. A law on the diagonal does what it is told; "
          "kelvin-voigt and exact-restitution hide behind it."};
}

report::Table table_of(const std::vector<LawStudy>& laws) {
  report::Table table{
      "How far each law is from what it was asked for, at worst, for 0.02 to 0.98; and how far the "
      "simulated impacts are from the closed relation.",
      {{"contact law", Alignment::left},
       {"worst at"},
       {"returns there"},
       {"off by"},
       {"asked for 0.1, returns"},
       {"asked for 0.9, returns"},
       {"simulated, off the relation by"}},
      {}};
  for (const LawStudy& law : laws) {
    const ReturnedRestitution worst = worst_of(law);
    const double off = std::abs(worst.returned - worst.asked);
    const auto state = off < 0.01 ? report::State::good : report::State::neutral;
    const bool exact = off < 5e-4;  // its worst place is a matter of rounding
    table.rows.push_back({{law.name},
                          {exact ? "–" : fmt::format("{:.2f}", worst.asked)},
                          {exact ? "–" : fmt::format("{:.3f}", worst.returned)},
                          {exact ? "< 0.0005" : fmt::format("{:.3f}", off), state},
                          {fmt::format("{:.3f}", closed_return(law.law, 0.1))},
                          {fmt::format("{:.3f}", closed_return(law.law, 0.9))},
                          {fmt::format("{:.0e}", largest_measurement_error(law))}});
  }
  return table;
}

std::string finding(const std::vector<LawStudy>& laws) {
  const double asked = 0.1;
  const double returned = closed_return(carrier_track::ContactLaw::hunt_crossley, asked);
  std::string faithful;
  for (const LawStudy& law : laws) {
    const ReturnedRestitution worst = worst_of(law);
    if (std::abs(worst.returned - worst.asked) > 0.01) continue;
    faithful += (faithful.empty() ? "" : ", ") + law.name;
  }
  return fmt::format(
      "Found: a \"restitution of {}\" with Hunt-Crossley's law really returns {:.3f}: the body "
      "keeps {:.0f} % of its energy of motion, not {:.0f} %. Everywhere within 0.01 of what they "
      "are asked for: {}.",
      asked, returned, 100 * returned * returned, 100 * asked * asked,
      faithful.empty() ? "none" : faithful);
}

}  // namespace

report::Section restitution_section(const std::vector<LawStudy>& laws) {
  report::Section section{"restitution", "What restitution does a contact law return?"};
  section.paragraphs = {
      finding(laws),
      "A contact law makes the force between body and wall from the penetration d and its rate d', "
      "F = K d^n (1 + D d' / v0) with approach speed v0, and takes the factor D of the damping "
      "from the restitution that it is asked for. Most published formulas for D are approximations "
      "made for bodies that lose little. The restitution e that an impact without other forces "
      "returns is the root of D (1 + e) = ln((1 + D) / (1 - e D)), whatever the stiffness, mass, "
      "exponent n and speed. Hertz's law has no damping; exact-restitution takes D from this "
      "relation. Kelvin and Voigt's spring and damper, F = max(0, K d + C d'), has a relation of "
      "its own, from which C is taken here.",
      "Sources: Hunt and Crossley (1975), Lankarani and Nikravesh (1990), Gonthier and others "
      "(2004), Zhiying and Qishao (2006), Flores and others (2011)."};
  section.tables = {table_of(laws)};
  section.figures = {chart_of(laws)};
  return section;
}

}  // namespace ricochet::studies::dynamics
