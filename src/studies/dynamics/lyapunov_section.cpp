#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/report/text.h"
#include "src/studies/dynamics/sections.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Alignment;
using report::Mark;

const double all_digits = 53 * std::log10(2.0);  // of a double: 15.95

report::Figure map_of(const LyapunovStudy& study) {
  report::Chart chart;
  chart.name = "lyapunov-digits";
  chart.title = "Digits of the start lost at worst, out of 16";
  chart.x.label = "speed [rad/s]";
  chart.y.label = "case";
  report::HeatMap map{"digits lost", {}, report::Range{0, 16}};
  for (const double speed : study.plan.speeds) {
    chart.x.categories.push_back(fmt::format("{:g}", speed));
  }
  for (std::size_t c = study.cases.size(); c-- > 0;) {  // from below
    chart.y.categories.push_back(study.cases[c]);
    auto& row = map.rows.emplace_back();
    for (const Sensitivity& cell : study.cells[c]) {
      row.push_back(cell.chaotic() ? std::nullopt : std::optional(cell.digits_lost));
    }
  }
  chart.heat_map = std::move(map);
  chart.width = 860;
  chart.height = 420;
  return {chart,
          "How many decimal digits of the start the motion of each case loses at worst before it "
          "rests on a wall, which forgets every difference. A number is computed with 16 digits: "
          "at 16 the motion would be a matter of chance. Hatched, if any: chaotic, it loses all."};
}

report::Figure courses_of(const LyapunovStudy& study) {
  report::Chart chart;
  chart.name = "lyapunov-courses";
  chart.title = "Digits lost, impact by impact";
  chart.x.label = "impacts since the start";
  chart.y = {"decimal digits of the start lost", report::Scale::linear, report::Range{-2, 22}};
  for (const Course& course : study.courses) {
    report::Series series{course.name, Mark::line, {}};
    for (std::size_t k = 0; k < course.digits_lost.size(); ++k) {
      const double digits = course.digits_lost[k];
      if (digits > chart.y.range->upper) break;
      series.samples.push_back({static_cast<double>(k), std::max(digits, -2.0)});
    }
    chart.series.push_back(std::move(series));
  }
  chart.lines = {{report::Direction::horizontal, all_digits, "nothing left of 16 digits"}};
  chart.width = 640;
  chart.height = 360;
  return {
      chart,
      "A line that rises loses digits. The paper's cases fall back at every rest on a wall; "
      "the chaotic scene goes through the dashed line, and from there on its path is a matter "
      "of rounding, until it, too, has its rest after a row of ever smaller hops. It is drawn up "
      "to 22 digits; losses below -2 (digits won) are drawn as that."};
}

report::Figure shaken_of(const LyapunovStudy& study) {
  report::Chart chart;
  chart.name = "lyapunov-gap";
  chart.title = "Lyapunov exponent of a shaken gap";
  chart.x.label = "gap, in amplitudes of the shaking";
  chart.y.label = "exponent, per period";
  report::Series exponents{"exponent", Mark::points, {}};
  report::Series resting{"forgets on a wall; growth in between", Mark::points, {}};
  for (std::size_t k = 0; k < study.shaken.size(); ++k) {
    const Sensitivity& shaken = study.shaken[k];
    auto& series = shaken.exponent() ? exponents : resting;
    series.samples.push_back({study.plan.gaps[k], shaken.growth * study.period});
  }
  chart.series = {std::move(exponents), std::move(resting)};
  const double pi = std::numbers::pi;
  const double rho = (1 - study.restitution) / (1 + study.restitution);
  using report::Direction;
  chart.lines = {
      {Direction::horizontal, 2 * std::log(study.restitution), "closed form: 2 ln(restitution)"},
      {Direction::vertical, (pi * pi - 4) / std::hypot(2, pi * rho), "closed form: stable between"},
      {Direction::vertical, std::hypot(pi, 2 * rho) / rho, "closed form: stable between"}};
  chart.width = 640;
  chart.height = 360;
  return {chart,
          "The check: a free mass between shaken walls. Between the vertical lines its orbit with "
          "two impacts a period is stable; well inside, a difference shrinks by the restitution at "
          "each impact, and at both ends it keeps its size. Above zero differences grow; squares: "
          "until a rest on "
          "a wall forgets them."};
}

struct Totals {
  int runs = 0, chaotic = 0, forgetting = 0;
  double digits = 0;                           // at worst
  double speed = 0;                            // there [rad/s]
  std::string the_case;                        // there
  double least_rests = 1e300, most_rests = 0;  // a turn, where there are several
};

Totals totals_of(const LyapunovStudy& study) {
  Totals totals;
  for (std::size_t c = 0; c < study.cells.size(); ++c) {
    for (std::size_t s = 0; s < study.cells[c].size(); ++s) {
      const Sensitivity& cell = study.cells[c][s];
      ++totals.runs;
      totals.chaotic += cell.chaotic();
      totals.forgetting += !cell.exponent();
      if (cell.digits_lost > totals.digits) {
        totals.digits = cell.digits_lost;
        totals.speed = study.plan.speeds[s];
        totals.the_case = study.cases[c];
      }
      const double rests = cell.rests_on_wall * 2 * std::numbers::pi / study.plan.speeds[s];
      if (rests * study.plan.turns < 1.5) continue;
      totals.least_rests = std::min(totals.least_rests, rests);
      totals.most_rests = std::max(totals.most_rests, rests);
    }
  }
  return totals;
}

std::string finding(const LyapunovStudy& study) {
  const Totals totals = totals_of(study);
  std::string text = fmt::format(
      "Found: {} of the {} motions of the paper's cases that were looked at is chaotic (12 cases "
      "at "
      "{} speeds from {:g} to {:g} rad/s, {:g} turns each). In {} of them the carrier rests on a "
      "wall, and forgets its start there altogether; in between it loses {:.1f} of 16 digits at "
      "worst, in {} at {:g} rad/s.",
      totals.chaotic == 0 ? "none" : std::to_string(totals.chaotic), totals.runs,
      study.plan.speeds.size(), study.plan.speeds.front(), study.plan.speeds.back(),
      study.plan.turns,
      totals.forgetting == totals.runs ? "all" : std::to_string(totals.forgetting), totals.digits,
      totals.the_case, totals.speed);
  if (totals.chaotic == 0 && totals.digits < 0.5 * all_digits) {
    text +=
        " So, as the paper is read here, no count is a matter of chance: where one jumps, an "
        "impact "
        "has crossed the limit from which it counts, or the end of the window.";
  }
  return text;
}

report::Table table_of(const LyapunovStudy& study) {
  report::Table table{
      "How long an impact can be trusted. \"Foretold\": impacts until one rounding has grown to "
      "everything, at the mean growth between rests on a wall. \"Seen\": two runs, started one "
      "rounding apart, until their impacts differ in wall or by a tenth of the time between two; "
      "runs that rest on a wall start anew there.",
      {{"motion", Alignment::left},
       {"digits lost an impact"},
       {"lost at worst before a rest on a wall"},
       {"foretold: trust until impact"},
       {"pairs of runs that part"},
       {"seen: first parts at impact"},
       {"half have parted by"}},
      {}};
  for (const Course& course : study.courses) {
    const Sensitivity& s = course.sensitivity;
    std::vector<int> parted = course.parted;
    std::sort(parted.begin(), parted.end());
    const bool lost = s.digits_lost > all_digits;
    table.rows.push_back(
        {{course.name},
         {fmt::format("{:.3f}", s.growth / s.impacts / std::numbers::ln10)},
         {fmt::format("{:.1f}", s.digits_lost), lost ? report::State::bad : report::State::good},
         {lost ? report::text_or_dash(s.impacts_foretold(), "{:.0f}") : "all"},
         {fmt::format("{} of {}", parted.size(), study.plan.starts)},
         {parted.empty() ? "never" : fmt::format("{}", parted.front())},
         {parted.empty() ? "never" : fmt::format("{}", parted[parted.size() / 2])}});
  }
  return table;
}

/// How many digits are left after so many impacts.
std::string trust_in(const LyapunovStudy& study) {
  const Course& lively = study.courses.front();
  const Course& chaotic = study.courses.back();
  const auto& parted = chaotic.parted;
  const double each = chaotic.sensitivity.growth / chaotic.sensitivity.impacts / std::numbers::ln10;
  return fmt::format(
      "In the chaotic scene, the one by that name above, a path is worth little after some dozens "
      "of impacts: each costs {:.2f} digits, so that after 30 impacts {:.0f} of 16 are left, after "
      "{} none; pairs of runs that part do so from impact {} on. The paper's cases are not like "
      "that: of {} pairs of runs of {}, with {:.0f} impacts in {:g} turns, {} part.",
      each, all_digits - 30 * each,
      report::text_or_dash(chaotic.sensitivity.impacts_foretold(), "{:.0f}"),
      parted.empty() ? "–" : std::to_string(*std::min_element(parted.begin(), parted.end())),
      study.plan.starts, lively.name, lively.impacts, study.plan.turns, lively.parted.size());
}

}  // namespace

report::Section lyapunov_section(const LyapunovStudy& study) {
  report::Section section{"lyapunov", "Is it chaos?"};
  const Totals totals = totals_of(study);
  section.paragraphs = {
      finding(study),
      fmt::format(
          "Two motions that start a hair apart may close up or drift apart. The Lyapunov exponent "
          "is the mean rate at which the logarithm of their distance grows: below zero a motion "
          "forgets its start, above zero it is chaotic. It is computed from exact derivatives of "
          "flights, impacts and turns, not from two runs. A rest on a wall makes it minus "
          "infinity: whatever came before, the carrier now lies still at a known place. The cases "
          "rest on a wall {:.2f} to {:.2f} times a turn, or lie there for good, because the gap of "
          "a millimetre is small beside the path that the forces would drive the carrier along.",
          totals.least_rests, totals.most_rests),
      trust_in(study)};
  section.tables = {table_of(study)};
  section.figures = {map_of(study), courses_of(study), shaken_of(study)};
  return section;
}

}  // namespace ricochet::studies::dynamics
