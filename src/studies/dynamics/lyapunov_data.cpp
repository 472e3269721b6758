#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/report/chart_data.h"
#include "src/studies/dynamics/lyapunov.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Direction;
using report::Json;
using report::Mark;

constexpr double pi = std::numbers::pi;
const double all_digits = 53 * std::log10(2.0);  // of a double: 15.95

report::Chart digits_chart(const LyapunovStudy& study) {
  report::Chart chart;
  chart.name = "lyapunov-digits";
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
  return chart;
}

report::Chart courses_chart(const LyapunovStudy& study) {
  report::Chart chart;
  chart.name = "lyapunov-courses";
  chart.x.label = "impacts since the start";
  chart.y = {"decimal digits of the start lost", report::Scale::linear, report::Range{-2, 22}};
  for (const Course& course : study.courses) {
    auto& series = chart.series.emplace_back(report::Series{course.name, Mark::line, {}});
    for (std::size_t k = 0; k < course.digits_lost.size(); ++k) {
      const double digits = course.digits_lost[k];
      if (digits > chart.y.range->upper) break;
      series.samples.push_back({static_cast<double>(k), std::max(digits, -2.0)});
    }
  }
  chart.lines = {{Direction::horizontal, all_digits, "nothing left of 16 digits"}};
  chart.width = 640;
  chart.height = 360;
  return chart;
}

report::Chart shaken_chart(const LyapunovStudy& study) {
  report::Chart chart;
  chart.name = "lyapunov-gap";
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
  const double rho = (1 - study.restitution) / (1 + study.restitution);
  chart.lines = {
      {Direction::horizontal, 2 * std::log(study.restitution), "closed form: 2 ln(restitution)"},
      {Direction::vertical, (pi * pi - 4) / std::hypot(2, pi * rho), "closed form: stable between"},
      {Direction::vertical, std::hypot(pi, 2 * rho) / rho, "closed form: stable between"}};
  chart.width = 640;
  chart.height = 360;
  return chart;
}

/// All motions of the paper's cases together.
Json cases_data(const LyapunovStudy& study) {
  int runs = 0, chaotic = 0, forgetting = 0;
  double digits = 0, speed = 0;  // at worst, and there [rad/s]
  std::string worst;
  double least_rests = 1e300, most_rests = 0;  // a turn, where there are several
  for (std::size_t c = 0; c < study.cells.size(); ++c) {
    for (std::size_t s = 0; s < study.cells[c].size(); ++s) {
      const Sensitivity& cell = study.cells[c][s];
      ++runs;
      chaotic += cell.chaotic();
      forgetting += !cell.exponent();
      if (cell.digits_lost > digits) {
        digits = cell.digits_lost;
        speed = study.plan.speeds[s];
        worst = study.cases[c];
      }
      const double rests = cell.rests_on_wall * 2 * pi / study.plan.speeds[s];
      if (rests * study.plan.turns < 1.5) continue;
      least_rests = std::min(least_rests, rests);
      most_rests = std::max(most_rests, rests);
    }
  }
  return {{"runs", runs},
          {"chaotic", chaotic},
          {"any_chaotic", chaotic > 0},
          {"forgetting", forgetting},
          {"all_forget", forgetting == runs},
          {"worst", {{"case", worst}, {"speed", speed}, {"digits", digits}}},
          {"no_chance", chaotic == 0 && digits < 0.5 * all_digits},
          {"least_rests", least_rests},
          {"most_rests", most_rests}};
}

Json data_of(const Course& course) {
  const Sensitivity& sensitivity = course.sensitivity;
  const double digits = sensitivity.growth / sensitivity.impacts / std::numbers::ln10;
  std::vector<int> parted = course.parted;
  std::sort(parted.begin(), parted.end());
  const bool any = !parted.empty();
  return {{"motion", course.name},
          {"impacts", course.impacts},
          {"digits_an_impact", digits},
          {"left_after_30", all_digits - 30 * digits},
          {"digits_at_worst", sensitivity.digits_lost},
          {"trusted", sensitivity.digits_lost <= all_digits},
          {"foretold", sensitivity.impacts_foretold()},
          {"parted", parted.size()},
          {"first_parted", any ? Json(parted.front()) : Json()},
          {"half_parted", any ? Json(parted[parted.size() / 2]) : Json()}};
}

}  // namespace

Json data_of(const LyapunovStudy& study) {
  const std::vector<double>& speeds = study.plan.speeds;
  Json courses = Json::array();
  for (const Course& course : study.courses) courses.push_back(data_of(course));
  return {
      {"speeds", {{"tried", speeds.size()}, {"first", speeds.front()}, {"last", speeds.back()}}},
      {"turns", study.plan.turns},
      {"pairs", study.plan.starts},
      {"cases", cases_data(study)},
      {"lively", courses.front()},
      {"chaotic", courses.back()},
      {"courses", courses},
      {"digits_chart", report::data_of(digits_chart(study))},
      {"courses_chart", report::data_of(courses_chart(study))},
      {"shaken_chart", report::data_of(shaken_chart(study))}};
}

}  // namespace ricochet::studies::dynamics
