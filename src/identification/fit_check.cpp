#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "src/identification/knock_fit.h"

namespace ricochet::studies::identification {

using namespace carrier_track;

namespace {

constexpr std::size_t speeds = 5;
constexpr std::size_t groups = 2 * speeds;

/// Chi-square of `groups` degrees of freedom, exceeded with a probability of 1e-5.
constexpr double most_chi_square = 41.3;

/// Deviations from prior knowledge, and units of the log likelihood that doing without it may gain:
/// exceeded with a probability of 0.003 and 1e-4.
constexpr double most_deviations = 3;
constexpr double most_gain = 8;

struct Residual {
  double time, omega;
  Wall wall;
  double late;      ///< in jitters
  double stronger;  ///< ln of the strength, in deviations; 0 if it is saturated
};

/// Of the knocks that belong to an impact more likely than not, and to no other by half as much.
std::vector<Residual> residuals_of(const KnockLoss& loss, const Vector& x) {
  const KnockDensity density = loss.density(x);
  const KnockUnknowns at = unknowns_at(x);
  const KnockRecord& record = loss.record();
  std::vector<Residual> result;
  for (const Knock& knock : record.knocks) {
    const auto& impacts = density.impacts();
    const PredictedImpact* nearest = nullptr;
    int close = 0;
    const double reach = 4 * at.jitter;
    for (auto impact =
             std::ranges::lower_bound(impacts, knock.time - reach, {}, &PredictedImpact::time);
         impact != impacts.end() && impact->time <= knock.time + reach; ++impact) {
      if (density.recorded_share(*impact) < 0.05) continue;
      nearest = &*impact;
      ++close;
    }
    if (close != 1) continue;
    const bool measured = knock.strength && *knock.strength < record.saturation;
    const double stronger =
        measured ? (std::log(*knock.strength / at.gain) - nearest->log_speed) / at.scatter : 0;
    if (std::abs(stronger) > 4) continue;
    // Strengths just above the detection limit are one-sided.
    const bool near_limit =
        knock.strength &&
        std::log(at.gain / at.detection_limit) + nearest->log_speed < 3 * at.scatter;
    result.push_back({knock.time, speed_at(record.speed, knock.time), nearest->wall,
                      (knock.time - nearest->time) / at.jitter, near_limit ? 0 : stronger});
  }
  return result;
}

struct Group {
  double n = 0, sum = 0, squares = 0, slowest = 1e300, fastest = 0;
  double mean() const { return sum / n; }
  double chi_square() const {
    if (n < 5) return 0;
    const double variance = std::max((squares - sum * sum / n) / (n - 1), 1.0);
    return n * mean() * mean() / variance;
  }
};

std::string range_of(const Group& group, std::size_t k) {
  return fmt::format("on the {} wall at {:.3g} to {:.3g} rad/s", k < speeds ? "lower" : "upper",
                     group.slowest, group.fastest);
}

struct Worst {
  double chi_square;
  Group group;
  std::size_t index;
};

/// The sum of chi-squares of the mean residuals in groups of a wall and a range of speeds, and the
/// group that adds most.
Worst worst_of(const std::vector<Residual>& residuals, double Residual::*number) {
  std::array<Group, groups> all;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const Residual& r = residuals[i];
    const std::size_t speed = i * speeds / residuals.size();
    Group& group = all[speed + (r.wall == Wall::upper ? speeds : 0)];
    if (r.*number == 0) continue;
    ++group.n;
    group.sum += r.*number;
    group.squares += r.*number * (r.*number);
    group.slowest = std::min(group.slowest, r.omega);
    group.fastest = std::max(group.fastest, r.omega);
  }
  Worst worst{0, all[0], 0};
  for (std::size_t k = 0; k < groups; ++k) {
    worst.chi_square += all[k].chi_square();
    if (all[k].chi_square() > worst.group.chi_square()) {
      worst.group = all[k];
      worst.index = k;
    }
  }
  return worst;
}

void add_residuals(std::vector<std::string>& found, const KnockLoss& loss, const Vector& x) {
  std::vector<Residual> residuals = residuals_of(loss, x);
  std::ranges::stable_sort(residuals, {}, &Residual::omega);
  const KnockUnknowns at = unknowns_at(x);
  const Worst late = worst_of(residuals, &Residual::late);
  if (late.chi_square > most_chi_square) {
    found.push_back(fmt::format(
        "The record contradicts the predicted times: knocks {} are {:.2g} ms {} on average "
        "(chi-square {:.0f}, 10 degrees of freedom). The recorded speeds or the model are wrong.",
        range_of(late.group, late.index), 1e3 * at.jitter * std::abs(late.group.mean()),
        late.group.mean() > 0 ? "late" : "early", late.chi_square));
  }
  const Worst stronger = worst_of(residuals, &Residual::stronger);
  if (stronger.chi_square > most_chi_square) {
    found.push_back(fmt::format(
        "The record contradicts strengths proportional to the impact speed: knocks {} are {:.0f} % "
        "{} on average (chi-square {:.0f}, 10 degrees of freedom). Try without strengths.",
        range_of(stronger.group, stronger.index),
        100 * std::abs(std::expm1(at.scatter * stronger.group.mean())),
        stronger.group.mean() > 0 ? "stronger" : "weaker", stronger.chi_square));
  }
}

void add_shares(std::vector<std::string>& found, const KnockRecord& record, const Vector& x) {
  const KnockUnknowns at = unknowns_at(x);
  const double spurious =
      at.spurious_rate * record.duration() / static_cast<double>(record.knocks.size());
  const double missed = 1 - std::max(at.recorded_share, at.upper_share);
  if (spurious <= 0.3 && missed <= 0.4) return;
  found.push_back(fmt::format(
      "The record contradicts the model or the speed: the machine explains only {:.0f} % of the "
      "knocks, and {:.0f} % of the impacts that it predicts are missing.",
      100 * std::max(0.0, 1 - spurious), 100 * missed));
}

void add_priors(std::vector<std::string>& found, const KnockLoss& loss, const Vector& x) {
  const KnockRecord& record = loss.record();
  const KnockUnknowns at = unknowns_at(x);
  if (std::abs(at.lag) > most_deviations * record.lag_deviation) {
    found.push_back(fmt::format(
        "The record contradicts the lag of 0 +- {:.3g} ms between knocks and speeds: fitted is "
        "{:.3g} ms. Should it be so, raise --lag-deviation.",
        1e3 * record.lag_deviation, 1e3 * at.lag));
  }
  if (record.lag_deviation > 0 && std::abs(at.drift) > most_deviations * 1e-4) {
    found.push_back(
        fmt::format("The record contradicts clocks that agree to 100 ppm: fitted are {:.0f} ppm.",
                    1e6 * at.drift));
  }
  if (!record.plate) return;
  const Vector off = x.segment(coordinate::phase, 2) - loss.guess().segment(coordinate::phase, 2);
  const double deviations = std::sqrt(off.dot(record.plate->information * off));
  if (deviations > most_deviations) {
    found.push_back(
        fmt::format("The record contradicts the marks by {:.1f} standard deviations: fitted are an "
                    "angle {:.2g} "
                    "degrees and a speed {:.2g} % away from theirs. Check --mark-angle; should it "
                    "be uncertain, "
                    "raise --mark-deviation.",
                    deviations, off[0] * 180 / std::numbers::pi, 100 * std::expm1(off[1])));
  }
}

/// Does a fit with another lag, clock or mark angle explain the record much better?
void add_without(std::vector<std::string>& found, const KnockLoss& loss, const KnockFit& fit,
                 const Solver& solver) {
  const auto add_if_better = [&](const KnockRecord& changed, const auto& sentence) {
    const KnockLoss other(loss.scene(), changed);
    Vector x = fit.x;
    const double better = fit.loss - refine(other, solver, x);
    if (better > most_gain) found.push_back(sentence(x, better));
  };
  const KnockRecord& record = loss.record();
  if (record.lag_deviation == 0) {
    KnockRecord lagging = record;
    lagging.lag_deviation = 0.02;
    add_if_better(lagging, [](const Vector& x, double better) {
      return fmt::format(
          "The record contradicts one clock of knocks and speeds: with a lag of {:.3g} ms and a "
          "drift of {:.0f} ppm the logarithm of the likelihood is better by {:.0f}. Give "
          "--lag-deviation.",
          1e3 * x[coordinate::lag], 1e6 * x[coordinate::drift], better);
    });
  }
  if (record.plate) {
    KnockRecord turned = record;
    const Vector of_phase = record.plate->information.col(0);
    constexpr double spread = 0.3 * 0.3;  // [rad^2]
    turned.plate->information -=
        of_phase * of_phase.transpose() * (spread / (1 + spread * of_phase[0]));
    add_if_better(turned, [&](const Vector& x, double better) {
      return fmt::format(
          "The record contradicts the marks' angle: with marks {:.2g} degrees away the logarithm "
          "of the likelihood is better by {:.0f}. Check --mark-angle, or raise --mark-deviation.",
          (x[coordinate::phase] - record.plate->phase) * 180 / std::numbers::pi, better);
    });
  }
}

}  // namespace

std::vector<std::string> contradictions(const KnockLoss& loss, const KnockFit& fit,
                                        const Solver& solver) {
  std::vector<std::string> found;
  add_shares(found, loss.record(), fit.x);
  add_residuals(found, loss, fit.x);
  if (loss.record().lag_deviation > 0 || loss.record().plate) add_priors(found, loss, fit.x);
  add_without(found, loss, fit, solver);
  return found;
}

namespace {

constexpr double shown_deviations = 5;
constexpr int width = 960, height = 320;

std::vector<PredictedImpact> recordable(const KnockDensity& density) {
  std::vector<PredictedImpact> impacts;
  for (const PredictedImpact& impact : density.impacts()) {
    if (density.recorded_share(impact) > 0.05) impacts.push_back(impact);
  }
  return impacts;
}

/// How much later [s] than the nearest predicted impact a knock is; nothing without impacts.
std::optional<double> delay(const std::vector<PredictedImpact>& impacts, double time) {
  const auto after = std::ranges::lower_bound(impacts, time, {}, &PredictedImpact::time);
  std::optional<double> nearest;
  if (after != impacts.end()) nearest = time - after->time;
  if (after != impacts.begin()) {
    const double late = time - std::prev(after)->time;
    if (!nearest || late < -*nearest) nearest = late;
  }
  return nearest;
}

report::Chart residual_chart(const KnockLoss& loss, const std::vector<PredictedImpact>& impacts,
                             double jitter) {
  report::Chart chart;
  chart.name = "residuals";
  chart.title = "Recorded minus predicted times";
  chart.x.label = "time [s]";
  chart.y.label = "residual [ms]";
  const double limit = shown_deviations * jitter;
  chart.y.range = report::Range{-1.2e3 * limit, 1.2e3 * limit};
  report::Series near{"knock", report::Mark::points, {}};
  report::Series far{"knock that no impact explains, at the edge", report::Mark::points, {}, true};
  for (const Knock& knock : loss.record().knocks) {
    const std::optional<double> late = delay(impacts, knock.time);
    if (late && std::abs(*late) <= limit) {
      near.samples.push_back({knock.time, 1e3 * *late});
    } else {
      far.samples.push_back({knock.time, late && *late < 0 ? -1.1e3 * limit : 1.1e3 * limit});
    }
  }
  for (report::Series* series : {&near, &far}) {
    if (!series->samples.empty()) chart.series.push_back(std::move(*series));
  }
  chart.lines = {{report::Direction::horizontal, 1e3 * jitter, "jitter, as fitted"},
                 {report::Direction::horizontal, -1e3 * jitter, "jitter, as fitted"}};
  return chart;
}

report::Chart angle_chart(const KnockLoss& loss, const std::vector<PredictedImpact>& impacts,
                          const KnockUnknowns& at) {
  const KnockRecord& record = loss.record();
  const auto angles = [&](const auto& events) {
    std::vector<report::Sample> samples;
    double time = record.from;
    double turned = 0;
    for (const auto& event : events) {
      turned += angle_between(record.speed, time, event.time);
      time = event.time;
      const double alpha = at.phase + at.speed_factor * turned;
      const double turns = alpha / (2 * std::numbers::pi);
      samples.push_back({time, 360 * (turns - std::floor(turns))});
    }
    return samples;
  };
  report::Chart chart;
  chart.name = "angles";
  chart.title = "Where in the plate's turn the carrier knocks";
  chart.x.label = "time [s]";
  chart.y = {.label = "plate's angle [degrees]", .range = report::Range{0, 360}};
  chart.series = {{"predicted", report::Mark::points, angles(impacts), true},
                  {"recorded", report::Mark::points, angles(record.knocks)}};
  return chart;
}

}  // namespace

std::vector<report::Chart> knock_charts(const KnockLoss& loss, const Vector& x) {
  const std::vector<PredictedImpact> impacts = recordable(loss.density(x));
  const KnockUnknowns at = unknowns_at(x);
  std::vector<report::Chart> charts = {residual_chart(loss, impacts, at.jitter),
                                       angle_chart(loss, impacts, at)};
  for (report::Chart& chart : charts) {
    chart.x.range = report::Range{loss.record().from, loss.record().to};
    chart.width = width;
    chart.height = height;
  }
  return charts;
}

}  // namespace ricochet::studies::identification
