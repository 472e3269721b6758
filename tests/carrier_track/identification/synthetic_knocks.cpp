#include "tests/carrier_track/identification/synthetic_knocks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/identification/knock_unknowns.h"
#include "problems/carrier_track/scene/scene_values.h"

namespace ricochet::carrier_track::inline identification {

std::vector<double> mark_times(const Scene& scene, const KnockRecord& record, double jitter,
                               Random& random) {
  constexpr double turn = 2 * std::numbers::pi;
  std::vector<double> marks;
  double angle = turn * std::ceil(scene.phase / turn) - scene.phase;
  const double last = angle_between(record.speed, record.from, record.to);
  for (; angle < last; angle += turn) {
    const double time = time_to_turn(record.speed, angle);
    marks.push_back(time + jitter * normal(1, random)[0]);
  }
  return marks;
}

KnockRecord synthetic_knocks(const Scene& scene, const std::vector<SpeedKnot<double>>& speed,
                             const SensorModel& sensor, Random& random) {
  KnockRecord record{{}, speed, 0, speed.back().time};
  const double slowest = sensor.detection_limit * std::exp(-5 * sensor.scatter);
  const auto gauss = [&random] { return normal(1, random)[0]; };
  std::vector<double> strengths;
  const auto keep = [&](double time, double strength) {
    do {
      if (time < record.from || time > record.to) return;
      record.knocks.push_back({time, std::min(strength, sensor.saturation)});
      time += sensor.echo_delay;
      strength *= sensor.echo_ratio;
    } while (sensor.echo_delay > 0 && strength >= sensor.detection_limit);
  };
  KnockUnknowns truth = guess_of(scene);
  truth.lag = sensor.lag;
  truth.drift = sensor.drift;
  for (const PredictedImpact& impact : plain_impacts(scene, record, point_of(truth), slowest)) {
    const double gain = impact.wall == Wall::upper ? sensor.upper_gain : 1;
    const double strength = gain * std::exp(impact.log_speed + sensor.scatter * gauss());
    if (strength < sensor.detection_limit) continue;
    strengths.push_back(strength);
    const double time = impact.time + sensor.jitter * gauss();
    if (uniform(random) >= sensor.missed_share) keep(time, strength);
  }
  // A Poisson process: its gaps are exponential.
  const double rate =
      sensor.spurious_share * static_cast<double>(strengths.size()) / record.duration();
  for (double time = record.from; rate > 0 && !strengths.empty();) {
    time -= std::log(1 - uniform(random)) / rate;
    if (time > record.to) break;
    const auto any =
        static_cast<std::size_t>(uniform(random) * static_cast<double>(strengths.size()));
    keep(time, strengths[any]);
  }
  std::ranges::sort(record.knocks, {}, &Knock::time);
  double heard = record.from - sensor.dead_time;
  std::erase_if(record.knocks, [&](const Knock& knock) {
    if (knock.time < heard + sensor.dead_time) return true;
    heard = knock.time;
    return false;
  });
  if (!sensor.strengths) {
    for (Knock& knock : record.knocks) knock.strength.reset();
  }
  if (sensor.mark_jitter) {
    record.plate =
        plate_measurement(record, mark_times(scene, record, *sensor.mark_jitter, random), 0);
  }
  return record;
}

}  // namespace ricochet::carrier_track::inline identification
