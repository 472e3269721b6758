#include "src/research/long_run/border_law.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/regimes/steady_motion.h"
#include "ricochet/regimes.h"
#include "src/research/long_run/count_fit.h"
#include "src/research/paper/threshold_formula.h"
#include "src/research/paper/throw.h"

namespace ricochet::studies::long_run {

using namespace carrier_track;

namespace {

constexpr int at_most = 2;
constexpr double fastest = 100;            // [rad/s]
constexpr double least = 0.2, most = 0.8;  // restitutions between the paper's
constexpr double paper_restitutions[] = {0.1, 0.9};
constexpr double paper_frictions[] = {0.1, 0.4};

Scene changed(Scene machine, double restitution, double friction) {
  machine.restitution_lower = machine.restitution_upper = restitution;
  machine.friction = friction;
  machine.disturbance = 0;
  return machine;
}

std::optional<double> border_of(const Scene& machine) {
  const auto border = quiet_up_to(machine, at_most, {0.01, fastest});
  return border == fastest ? std::nullopt : border;
}

/// Whether the carrier strikes both walls just below a border.
bool strikes_both(const Scene& machine, double border) {
  const SteadyMotion motion = steady_motion(at_speed(machine, 0.98 * border));
  const auto strikes = [&](Wall wall) {
    return std::ranges::any_of(motion.impacts, [&](const Impact& i) { return i.wall == wall; });
  };
  return strikes(Wall::lower) && strikes(Wall::upper);
}

std::vector<ThresholdPoint> paper_points() {
  std::vector<ThresholdPoint> points;
  for (const Case& c : cases_with_threshold()) {
    points.push_back({c.id, c.restitution, c.friction, c.disturbance, *c.claim.threshold});
  }
  return points;
}

std::vector<ThresholdPoint> corner_points(const Scene& machine) {
  std::vector<ThresholdPoint> points;
  for (const double e : paper_restitutions) {
    for (const double mu : paper_frictions) {
      if (const auto border = border_of(changed(machine, e, mu))) {
        points.push_back({"", e, mu, 0, *border});
      }
    }
  }
  return points;
}

std::vector<ThresholdPoint> border_points(const std::vector<LawPoint>& points) {
  std::vector<ThresholdPoint> known;
  for (const LawPoint& p : points) {
    if (p.border) known.push_back({"", p.restitution, p.friction, 0, *p.border});
  }
  return known;
}

PredictionErrors errors_at(const Formula& formula, const std::vector<double>& constants,
                           const std::vector<ThresholdPoint>& points) {
  std::vector<double> predicted;
  for (const ThresholdPoint& p : points) predicted.push_back(formula.threshold(constants, p));
  return carrier_track::errors_of(points, predicted);
}

FormulaWorth worth_of(const std::vector<ThresholdPoint>& fitted_to,
                      const std::vector<ThresholdPoint>& borders) {
  const Formula formula = friction_formula();
  const std::vector<double> constants = formula.fit(fitted_to).value();
  std::vector<ThresholdPoint> between;
  std::ranges::copy_if(borders, std::back_inserter(between), [](const ThresholdPoint& p) {
    return p.restitution > least - 1e-9 && p.restitution < most + 1e-9;
  });
  const PredictionErrors all = errors_at(formula, constants, borders);
  const PredictionErrors inner = errors_at(formula, constants, between);
  return {constants[0], constants[1], all.rms, all.worst, inner.rms, inner.worst};
}

}  // namespace

LawComparison compared(const Scene& machine, const std::vector<double>& restitutions,
                       const std::vector<double>& frictions) {
  LawComparison result{};
  for (const double mu : frictions) {
    for (const double e : restitutions) result.points.push_back({e, mu, {}, {}});
  }
  std::vector<double> struck(result.points.size());  // the errors where both walls are
  tbb::parallel_for(std::size_t{0}, result.points.size(), [&](std::size_t i) {
    LawPoint& point = result.points[i];
    const Scene here = changed(machine, point.restitution, point.friction);
    point.border = border_of(here);
    point.law = throw_border(here, at_most, Louder::some, fastest);
    if (point.border && point.law && strikes_both(here, *point.border)) {
      struck[i] = std::abs(std::log(*point.law / *point.border));
    }
  });
  result.law_worst_struck = *std::ranges::max_element(struck);
  double squares = 0;
  int known = 0;
  for (const LawPoint& point : result.points) {
    if (!point.border || !point.law) continue;
    const double error = std::abs(std::log(*point.law / *point.border));
    squares += error * error;
    ++known;
    result.law_worst = std::max(result.law_worst, error);
  }
  result.law_rms = std::sqrt(squares / std::max(1, known));
  const std::vector<ThresholdPoint> borders = border_points(result.points);
  result.of_paper = worth_of(paper_points(), borders);
  result.of_corners = worth_of(corner_points(machine), borders);
  result.of_all = worth_of(borders, borders);
  return result;
}

}  // namespace ricochet::studies::long_run
