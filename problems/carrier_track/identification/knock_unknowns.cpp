#include "problems/carrier_track/identification/knock_unknowns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/motion/dual_simulation.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/scene/scene_values.h"

namespace ricochet::carrier_track::inline identification {

namespace {

double logit(double share) {
  return std::log(share / (1 - share));
}

double share_at(double logit) {
  return 1 / (1 + std::exp(-logit));
}

}  // namespace

Vector point_of(const KnockUnknowns& u) {
  Vector x(knock_unknowns);
  x << logit(u.restitution), std::log(u.friction), std::log(u.clearance), u.phase,
      std::log(u.speed_factor), std::log(u.jitter), logit(u.recorded_share),
      std::log(u.spurious_rate), std::log(u.detection_limit), std::log(u.gain), std::log(u.scatter),
      logit(u.upper_share), u.lag, u.drift;
  return x;
}

KnockUnknowns unknowns_at(const Vector& x) {
  return {.restitution = share_at(x[0]),
          .friction = std::exp(x[1]),
          .clearance = std::exp(x[2]),
          .phase = x[3],
          .speed_factor = std::exp(x[4]),
          .jitter = std::exp(x[5]),
          .recorded_share = share_at(x[6]),
          .spurious_rate = std::exp(x[7]),
          .detection_limit = std::exp(x[8]),
          .gain = std::exp(x[9]),
          .scatter = std::exp(x[10]),
          .upper_share = share_at(x[11]),
          .lag = x[12],
          .drift = x[13]};
}

Vector slopes_at(const Vector& x) {
  const KnockUnknowns u = unknowns_at(x);
  Vector slopes(machine_constants);
  slopes << u.restitution * (1 - u.restitution), u.friction, u.clearance;
  return slopes;
}

KnockUnknowns guess_of(const Scene& scene) {
  return {.restitution = std::clamp(scene.restitution_lower, 0.01, 0.99),
          .friction = std::max(scene.friction, 1e-3),
          .clearance = scene.wall_upper - scene.wall_lower,
          .phase = scene.phase,
          .speed_factor = 1,
          .jitter = 1e-3,
          .recorded_share = 0.9,
          .spurious_rate = 0.2,
          .detection_limit = scene.counting_limit,
          .gain = 1,
          .scatter = 0.1};
}

Scene with_constants(Scene scene, const KnockUnknowns& unknowns) {
  scene.restitution_lower = scene.restitution_upper = unknowns.restitution;
  scene.friction = unknowns.friction;
  scene.wall_upper = scene.wall_lower + unknowns.clearance;
  scene.start_position = scene.wall_lower;
  return scene;
}

namespace {

constexpr double settling_turns = 2;

/// How long [s] the carrier is simulated before the record begins.
double settling_time(const KnockRecord& record) {
  const double omega = speed_at(record.speed, record.from);
  return omega > 0 ? settling_turns * 2 * std::numbers::pi / omega : 0;
}

/// Collects impacts, with their times on the clock of the knocks.
template <class Scalar>
class Collector : public Observer {
 public:
  Collector(double settling, double from, double slowest, const KnockUnknowns& at)
      : settling_(settling), from_(from), slowest_(slowest), lag_(at.lag), rate_(1 + at.drift) {}

  static constexpr bool hears_stretches() { return false; }

  void impact(const Scalar& time, Wall wall, const Scalar& speed) {
    if (value(speed) <= slowest_) return;
    PredictedImpact impact{from_ + (value(time) - settling_) * rate_ + lag_, std::log(value(speed)),
                           wall};
    if (impact.time < from_) return;
    if constexpr (Dual<Scalar>) {
      for (int i = 0; i < motion_unknowns; ++i) {
        const auto k = static_cast<std::size_t>(i);
        impact.time_slopes[k] = time.v[i] * rate_;
        impact.log_speed_slopes[k] = speed.v[i] / value(speed);
      }
    }
    impacts.push_back(impact);
  }

  std::vector<PredictedImpact> impacts;

 private:
  double settling_, from_, slowest_, lag_, rate_;
};

/// The unknowns of the motion as scalars that carry derivatives by the coordinates.
template <class Scalar>
std::array<Scalar, motion_unknowns> motion_at(const Vector& x) {
  using std::exp;
  std::array<Scalar, motion_unknowns> at;
  for (int i = 0; i < motion_unknowns; ++i) {
    auto& coordinate = at[static_cast<std::size_t>(i)];
    coordinate = constant<Scalar>(x[i]);
    if constexpr (Dual<Scalar>) coordinate.v[i] = 1;
  }
  const Scalar one = constant<Scalar>(1.0);
  return {one / (one + exp(-at[0])), exp(at[1]), exp(at[2]), at[3], exp(at[4])};
}

template <class Scalar>
std::vector<PredictedImpact> impacts_of(const Scene& plain, const KnockRecord& record,
                                        const Vector& x, double slowest) {
  const double settling = settling_time(record);
  const auto [restitution, friction, clearance, phase, factor] = motion_at<Scalar>(x);
  BasicScene<Scalar> scene = lifted<Scalar>(plain);
  scene.restitution_lower = scene.restitution_upper = restitution;
  scene.friction = friction;
  scene.wall_upper = scene.wall_lower + clearance;
  scene.start_position = scene.wall_lower;
  scene.start_velocity = constant<Scalar>(0.0);
  const double before = settling * speed_at(record.speed, record.from);
  scene.phase = phase - constant<Scalar>(before) * factor;
  scene.profile = {{0, constant<Scalar>(speed_at(record.speed, record.from)) * factor}};
  for (const SpeedKnot<double>& knot : record.speed) {
    const double time = knot.time - record.from + settling;
    if (knot.time <= record.from) continue;
    if (scene.profile.size() == 1 && settling > 0) {
      scene.profile.push_back({settling, scene.profile.front().omega});
    }
    scene.profile.push_back({time, constant<Scalar>(knot.omega) * factor});
  }
  const KnockUnknowns at = unknowns_at(x);
  scene.window = Seconds{settling + (record.duration() - at.lag) / (1 + at.drift)};
  Collector<Scalar> collector(settling, record.from, slowest, at);
  // Rebounds far below what is asked for are summed: two thirds of all impacts, and of the time.
  const double resting = 0.02 * slowest;
  if (record.speed.size() == 1) {
    scene.omega = scene.profile.front().omega;
    ImpactModel<Scalar, AppliedForces<Scalar>>(scene, resting).run(collector);
  } else {
    ImpactModel<Scalar, ProfileForces<Scalar>>(scene, resting).run(collector);
  }
  return std::move(collector.impacts);
}

}  // namespace

std::vector<PredictedImpact> predicted_impacts(const Scene& scene, const KnockRecord& record,
                                               const Vector& x, double slowest) {
  return impacts_of<DesignDual>(scene, record, x, slowest);
}

std::vector<PredictedImpact> plain_impacts(const Scene& scene, const KnockRecord& record,
                                           const Vector& x, double slowest) {
  return impacts_of<double>(scene, record, x, slowest);
}

}  // namespace ricochet::carrier_track::inline identification
