#include "src/studies/surrogate/growth.h"

#include <ceres/jet.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "problems/carrier_track/paper/cases.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/campaign/progress.h"
#include "src/studies/dynamics/work.h"
#include "src/studies/surrogate/line_fit.h"

namespace ricochet::studies::surrogate {
namespace {

using namespace carrier_track;
using Jet = ceres::Jet<double, 1>;

constexpr double box = 18;  // [rad/s]

Scene in_window(const Driven& driven, double turns) {
  Scene scene = driven.scene;
  scene.window = Seconds{turns * 2 * std::numbers::pi / driven.rate()};
  if (!driven.shaken) scene.window = Revolutions{turns};
  return scene;
}

/// Notes how far the impacts move.
class Mover : public Observer {
 public:
  explicit Mover(const Driven& driven) : rate_(driven.rate()), slowest_(driven.scene.slowest) {}

  void impact(const Jet& time, Wall /*wall*/, const Jet& speed) {
    if (speed.a < slowest_) return;
    const double late = time.v[0] + time.a / rate_;  // [s] per rad/s, at the same phase
    const double length = std::hypot(speed.a * late, speed.v[0] / rate_);
    if (std::isfinite(length) && length > 0) moved.push_back({time.a, length});
  }

  std::vector<Stretched> moved;

 private:
  double rate_, slowest_;
};

}  // namespace

std::vector<Stretched> stretched_by_impact(const Driven& driven) {
  auto scene = lifted<Jet>(driven.scene);
  (driven.shaken ? scene.disturbance_frequency : scene.omega).v[0] = 1.0;
  Mover mover(driven);
  simulate(scene, mover);
  return mover.moved;
}

std::optional<double> rate_of(const std::vector<Stretched>& impacts, double window) {
  std::vector<Point> points;
  for (const Stretched& impact : impacts) {
    if (impact.time > 0.1 * window) points.push_back({impact.time, std::log(impact.length)});
  }
  return slope_of(points);
}

double GrowthCell::error_of(const Difference& difference) const {
  const double larger = std::max(std::abs(gradient), std::abs(difference.slope));
  if (larger == 0) return 0;
  const double apart = std::abs(gradient - difference.slope) / larger;
  return std::isfinite(apart) ? apart : 1.0;
}

GrowthCell growth_of(const Driven& driven, double turns) {
  Driven now = driven;
  now.scene = in_window(driven, turns);
  const double rate = now.rate();
  const Gradient exact = gradient_of<1>(now, Vector::Constant(1, rate), Vector::Constant(1, box));
  const double step = 1e-3 * rate;
  const auto value_at = [&](double x) { return value_of(now, Vector::Constant(1, x)); };
  return {turns,
          rate_of(stretched_by_impact(now), duration_of(now.scene)),
          dynamics::sensitivity_of(now.scene),
          exact.gradient[0],
          exact.trust,
          difference(value_at, rate, step),
          difference(value_at, rate, std::min(step, 0.25 * exact.trust.reach * box))};
}

std::vector<Driven> shaken_gaps() {
  const Scene chaotic = dynamics::benchmark_scene("chaotic", 1);
  std::vector<Driven> gaps = {{"chaotic scene", chaotic, true}};
  for (const double pull : {0.0, 0.5, 1.0}) {
    for (const double restitution : {0.6, 0.8, 0.9, 0.95}) {
      if (pull == 1 && restitution == chaotic.restitution_lower) continue;
      Scene scene = chaotic;
      scene.pull *= pull;
      scene.restitution_lower = scene.restitution_upper = restitution;
      gaps.push_back(
          {fmt::format("its pull x {:g}, restitution {:g}", pull, restitution), scene, true});
    }
  }
  return gaps;
}

GrowthStudy study_growth(const GrowthPlan& plan) {
  GrowthStudy study{plan, {}, {}};
  for (const Case& a_case : all_cases()) {
    for (const double speed : plan.speeds) {
      const Scene scene = at_speed(scene_of(a_case, default_reading().scene), speed);
      study.rows.push_back({{fmt::format("{} at {:g} rad/s", a_case.id, speed), scene}, {}, {}});
    }
  }
  for (Driven& gap : shaken_gaps()) study.rows.push_back({std::move(gap), {}, {}});
  Progress progress("growth", static_cast<double>(study.rows.size()));
  tbb::parallel_for(std::size_t{0}, study.rows.size(), [&](std::size_t k) {
    GrowthRow& row = study.rows[k];
    for (const double turns : plan.turns) row.cells.push_back(growth_of(row.driven, turns));
    Driven longest = row.driven;
    longest.scene = in_window(row.driven, plan.turns.back());
    row.stretched = stretched_by_impact(longest);
    progress.advance(1);
  });
  study.grazes = study_grazes(plan.grazes);
  return study;
}

}  // namespace ricochet::studies::surrogate
