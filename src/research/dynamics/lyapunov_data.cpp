#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/research/dynamics/lyapunov.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Json;

using std::numbers::pi;
const double all_digits = 53 * std::log10(2.0);  // of a double: 15.95

/// Digits lost by a motion; null if it loses all.
Json digits_of(const Sensitivity& motion) {
  return motion.chaotic() ? Json() : Json(motion.digits_lost);
}

/// By impact, as far as it is drawn.
Json drawn_digits(const Course& course) {
  Json drawn = Json::array();
  for (const double digits : course.digits_lost) {
    if (digits > 22) break;
    drawn.push_back(std::max(digits, -2.0));
  }
  return drawn;
}

/// Growth per period of the shaking over the gap, with the values of closed forms.
Json shaken_data(const LyapunovStudy& study) {
  Json gaps = Json::array();
  for (std::size_t k = 0; k < study.shaken.size(); ++k) {
    const Sensitivity& shaken = study.shaken[k];
    gaps.push_back({{"gap", study.plan.gaps[k]},
                    {"growth", shaken.growth * study.period},
                    {"rests", !shaken.exponent()}});
  }
  const double rho = (1 - study.restitution) / (1 + study.restitution);
  return {{"gaps", std::move(gaps)},
          {"growth", 2 * std::log(study.restitution)},
          {"stable_from", (pi * pi - 4) / std::hypot(2, pi * rho)},
          {"stable_to", std::hypot(pi, 2 * rho) / rho}};
}

/// All motions of the paper's cases together.
Json cases_data(const LyapunovStudy& study) {
  int runs = 0, chaotic = 0, forgetting = 0;
  double digits = 0, speed = 0;  // worst case, and its speed [rad/s]
  std::string worst;
  double least_rests = 1e300, most_rests = 0;  // per turn, if there are several
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
  const auto course_data = [](const Course& course) { return data_of(course); };
  const auto losses_of = [](const Course& course) -> Json {
    return {{"motion", course.name}, {"digits", drawn_digits(course)}};
  };
  const Json courses = report::list_of(study.courses, course_data);
  Json digits = Json::array();
  for (std::size_t c = 0; c < study.cases.size(); ++c) {
    digits.push_back(
        {{"case", study.cases[c]}, {"digits", report::list_of(study.cells[c], digits_of)}});
  }
  return {{"speeds",
           {{"tried", speeds.size()},
            {"first", speeds.front()},
            {"last", speeds.back()},
            {"all", speeds}}},
          {"turns", study.plan.turns},
          {"pairs", study.plan.starts},
          {"cases", cases_data(study)},
          {"lively", courses.front()},
          {"chaotic", courses.back()},
          {"courses", courses},
          {"all_digits", all_digits},
          {"losses", report::list_of(study.courses, losses_of)},
          {"digits", std::move(digits)},
          {"shaken", shaken_data(study)}};
}

}  // namespace ricochet::studies::dynamics
