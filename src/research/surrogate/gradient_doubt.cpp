#include "src/research/surrogate/gradient_doubt.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/problems/machine.h"
#include "problems/carrier_track/problems/speed_range.h"
#include "ricochet/problem.h"
#include "src/benchmark/statistics/bootstrap.h"
#include "src/core/progress.h"

namespace ricochet::studies::surrogate {
namespace {

using namespace carrier_track;
using report::Json;

constexpr double agreement = 1e-6;   // relative
constexpr double trend_reach = 0.5;  // [rad/s] to either side
constexpr int trend_points = 10;     // to either side

/// The results at one speed.
struct Finding {
  Slope slope;
  double trend;                ///< of the count, by least squares [per rad/s]
  std::vector<double> errors;  ///< relative, of differences of every step
};

double trend_of(const Scene& scene, double omega) {
  double products = 0;
  double squares = 0;
  for (int k = -trend_points; k <= trend_points; ++k) {
    const double shift = trend_reach * k / trend_points;
    const double speed = std::clamp(omega + shift, slowest_speed, fastest_speed);
    products += shift * objective(at_speed(scene, speed), 0.0);
    squares += shift * shift;
  }
  return products / squares;
}

Finding find(const Scene& scene, double omega, double smoothing, const std::vector<double>& steps) {
  const auto value_at = [&](double speed) { return objective(at_speed(scene, speed), smoothing); };
  Finding finding{surrogate_slope(at_speed(scene, omega), smoothing, fastest_speed - slowest_speed),
                  trend_of(scene, omega),
                  {}};
  for (const double share : steps) {
    const double step = share * fastest_speed;
    const double difference = (value_at(omega + step) - value_at(omega - step)) / (2 * step);
    const double error = std::abs(difference - finding.slope.slope);
    const double size = std::max(std::abs(difference), std::abs(finding.slope.slope));
    finding.errors.push_back(size > 0 ? error / size : 0.0);
  }
  return finding;
}

GradientQuality sum_of(std::span<const Finding> findings) {
  GradientQuality quality;
  std::vector<double> reaches;
  for (const Finding& f : findings) {
    ++quality.points;
    const Trust& trust = f.slope.trust;
    ++quality.doubts[static_cast<std::size_t>(trust.doubt)];
    quality.agreeing += std::any_of(f.errors.begin(), f.errors.end(),
                                    [](double error) { return error < agreement; });
    if (f.trend != 0 && trust.doubt != GradientDoubt::flat) {
      ++quality.trending;
      quality.right += (f.trend > 0) == (f.slope.slope > 0);
    }
    reaches.push_back(std::log10(std::min(trust.reach, 1.0)));
  }
  quality.log_reach = quantile(reaches, 0.5);
  return quality;
}

/// At points evenly spaced over the cells, without the ends of each.
std::vector<Finding> findings_of(const Machine& machine, double smoothing,
                                 const GradientDoubtPlan& plan) {
  const int points = plan.cells * plan.points;
  std::vector<Finding> findings(static_cast<std::size_t>(points));
  tbb::parallel_for(0, points, [&](int k) {
    // Starts at half of the first step, so that differences stay above 0.
    const double omega = fastest_speed * (k + 0.5) / points;
    findings[static_cast<std::size_t>(k)] =
        find(machine.scene, std::max(omega, 0.2), smoothing, plan.steps);
  });
  return findings;
}

}  // namespace

GradientDoubtStudy study_gradient_doubt(const GradientDoubtPlan& plan) {
  GradientDoubtStudy study{plan, {}, {}, {}, {}};
  const std::vector<Machine> machines = all_machines();
  Progress progress("gradient validity",
                    static_cast<double>(machines.size() * (plan.smoothings.size() + 1)));
  const auto size = static_cast<std::size_t>(plan.points);
  std::vector<std::vector<double>> errors(plan.steps.size());
  std::vector<Finding> all;
  for (const Machine& machine : machines) {
    const auto findings = findings_of(machine, default_smoothing, plan);
    CaseQuality& row = study.rows.emplace_back(CaseQuality{machine.id, {}});
    for (std::size_t first = 0; first < findings.size(); first += size) {
      row.cells.push_back(sum_of(std::span(findings).subspan(first, size)));
    }
    for (const Finding& f : findings) {
      if (f.slope.trust.doubt == GradientDoubt::flat) continue;
      for (std::size_t s = 0; s < errors.size(); ++s) errors[s].push_back(f.errors[s]);
    }
    all.insert(all.end(), findings.begin(), findings.end());
    progress.advance(1);
  }
  study.all = sum_of(all);
  for (std::size_t s = 0; s < errors.size(); ++s) {
    study.step_errors.push_back(
        {plan.steps[s], quantile(errors[s], 0.5), quantile(errors[s], 0.9)});
  }
  for (const double smoothing : plan.smoothings) {
    std::vector<Finding> every;
    for (const Machine& machine : machines) {
      for (Finding& f : findings_of(machine, smoothing, plan)) every.push_back(std::move(f));
      progress.advance(1);
    }
    study.by_smoothing.push_back(sum_of(every));
  }
  return study;
}

namespace {

/// Shares of the points, but `trending` is a share of those that have a trend.
Json quality_data(const GradientQuality& q) {
  const auto share = [](int part, int whole) {
    return whole > 0 ? Json(static_cast<double>(part) / whole) : Json();
  };
  const auto doubted = [&](GradientDoubt doubt) {
    return share(q.doubts[static_cast<std::size_t>(doubt)], q.points);
  };
  return {{"points", q.points},
          {"agreeing", share(q.agreeing, q.points)},
          {"flat", doubted(GradientDoubt::flat)},
          {"kink", doubted(GradientDoubt::kink)},
          {"sensitive", doubted(GradientDoubt::sensitive)},
          {"trending", share(q.right, q.trending)},
          {"reach", std::pow(10.0, q.log_reach)},
          {"log_reach", q.log_reach}};
}

}  // namespace

Json data_of(const GradientDoubtStudy& study) {
  Json smoothings = Json::array();
  for (std::size_t w = 0; w < study.plan.smoothings.size(); ++w) {
    smoothings.push_back({{"smoothing", study.plan.smoothings[w]}});
    smoothings.back().update(quality_data(study.by_smoothing[w]));
  }
  Json speeds = Json::array();
  for (int k = 0; k < study.plan.cells; ++k) {
    speeds.push_back((k + 0.5) * (fastest_speed / study.plan.cells));
  }
  const auto case_data = [](const CaseQuality& row) -> Json {
    return {{"id", row.id}, {"cells", report::list_of(row.cells, quality_data)}};
  };
  return {{"all", quality_data(study.all)},
          {"smoothings", std::move(smoothings)},
          {"speeds", std::move(speeds)},
          {"cases", report::list_of(study.rows, case_data)},
          {"steps", study.step_errors},
          {"best_step", std::ranges::min(study.step_errors, {}, &StepError::median)}};
}

}  // namespace ricochet::studies::surrogate
