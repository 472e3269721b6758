#include "problems/carrier_track/identification/predicted_impact.h"

#include <cmath>
#include <numbers>

#include "problems/carrier_track/models/dual_simulation.h"
#include "problems/carrier_track/models/impact_model.h"
#include "problems/carrier_track/scene/lifted.h"

namespace ricochet::carrier_track::inline identification {
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
