#include "problems/carrier_track/recording.h"

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/collisions.h"

namespace ricochet::carrier_track {
namespace {

class Recorder : public Observer {
 public:
  Recorder(Recording& recording, double spacing) : recording_(recording), spacing_(spacing) {}

  void impact(double time, Wall wall, double speed) {
    recording_.impacts.push_back({time, wall, speed});
  }

  void peak(double time, double position) { recording_.peaks.push_back({time, position}); }

  void contact(double time, double position, double velocity) {
    if (std::isfinite(spacing_)) recording_.path.push_back({time, position, velocity});
  }

  template <class Path>
  void stretch(double time, const Path& flight, double duration) {
    if (!std::isfinite(spacing_)) return;
    const auto pieces = std::max(1.0, std::ceil(duration / spacing_));
    for (double i = 0; i <= pieces; ++i) {
      const double t = duration * i / pieces;
      const Motion<double> m = flight.at(t);
      recording_.path.push_back({time + t, m.position, m.velocity});
    }
  }

 private:
  Recording& recording_;
  double spacing_;
};

}  // namespace

Recording record(const Scene& scene, double width, std::size_t samples) {
  Recording recording;
  const double spacing = samples > 0 ? duration_of(scene) / static_cast<double>(samples)
                                     : std::numeric_limits<double>::infinity();
  Recorder recorder(recording, spacing);
  recording.end = simulate(scene, recorder);
  const auto weigh = [&](double z) {
    recording.count += static_cast<int>(step(z, 0.0));
    recording.surrogate += step(z, width);
    recording.margin = std::min(recording.margin.value_or(std::abs(z)), std::abs(z));
  };
  Features<double, decltype(weigh)> features(scene, weigh);
  for (const Impact& i : recording.impacts) features.impact(i.time, i.wall, i.speed);
  for (const Peak& p : recording.peaks) features.peak(p.time, p.position);
  recording.certain = is_certain(scene, recording.count);
  return recording;
}

bool is_certain(const Scene& scene, int count) {
  for (const double change : {-1e-9, 1e-9}) {
    Scene near = scene;
    near.mass *= 1 + change;
    near.restitution_lower = std::min(1.0, near.restitution_lower * (1 + change));
    near.restitution_upper = std::min(1.0, near.restitution_upper * (1 + change));
    if (objective(near, 0.0) != count) return false;
  }
  return true;
}

}  // namespace ricochet::carrier_track
