#include "problems/carrier_track/counting/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "problems/carrier_track/counting/certainty.h"
#include "problems/carrier_track/counting/count.h"
#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline counting {

namespace {

class Recorder : public Observer {
 public:
  Recorder(const Scene& scene, Recording& recording, double spacing)
      : scene_(scene),
        recording_(recording),
        trace_(scene),
        spacing_(spacing),
        last_{0, scene.start_position} {}

  void impact(double time, Wall wall, double speed) {
    last_ = {time, wall == Wall::upper ? scene_.wall_upper : scene_.wall_lower};
    trace_.impact(time, wall, speed);
    recording_.impacts.push_back({time, wall, speed});
  }

  void peak(double time, double position) {
    last_ = {time, position};
    trace_.peak(time, position);
    recording_.peaks.push_back({time, position});
  }

  void turn(double time, double position, Wall ahead) {
    last_ = {time, position};
    trace_.turn(time, position, ahead);
  }

  void hops(double time, Wall wall) { trace_.hops(time, wall); }

  void contact(double time, double position, double velocity) {
    last_ = {time, position};
    trace_.contact(time, position, velocity);
    if (std::isfinite(spacing_)) sample({time, position, velocity});
  }

  bool hears_stretches() const { return std::isfinite(spacing_) || trace_.hears_stretches(); }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    trace_.stretch(time, path, duration);
    if (!std::isfinite(spacing_)) return;
    const auto pieces = std::max(1.0, std::ceil(duration / spacing_));
    for (double i = 0; i <= pieces; ++i) {
      const double t = duration * i / pieces;
      const Motion<double> m = path.at(t);
      sample({time + t, m.position, m.velocity});
    }
  }

  const FeatureTrace& trace() const { return trace_; }

  /// Where the body was at the last event; its velocity is not known.
  End<double> last() const {
    return {last_.time, last_.position, std::numeric_limits<double>::quiet_NaN(), 0};
  }

 private:
  struct Place {
    double time, position;
  };

  /// Keeps a sample. Where one flight ends and another begins, both have the same.
  void sample(const Sample& added) {
    if (!recording_.path.empty()) {
      const Sample& last = recording_.path.back();
      if (last.time == added.time && last.position == added.position &&
          last.velocity == added.velocity) {
        return;
      }
    }
    recording_.path.push_back(added);
  }

  const Scene& scene_;
  Recording& recording_;
  FeatureTrace trace_;
  double spacing_;
  Place last_;
};

/// The scene at the level of the model that it needs; at the cheapest if there is no time to
/// choose.
Scene resolved_in_time(Scene scene) {
  try {
    return resolve_fidelity(scene);
  } catch (const TimeLimitReached&) {
    scene.fidelity = Fidelity::impact;
    return scene;
  }
}

/// That a count is not certain because the time limit was reached.
Certainty unfinished(const Recording& recording, double duration) {
  Certainty certainty;
  certainty.certain = false;
  certainty.doubt = Doubt::unfinished;
  certainty.reason =
      recording.complete
          ? "the time limit was reached before its certainty was known"
          : fmt::format("the time limit was reached at {:.6g} s of the {:.6g} s of the window",
                        recording.end.time, duration);
  return certainty;
}

}  // namespace

Recording record(const Scene& asked, double smoothing, std::size_t samples) {
  if (!(smoothing >= 0 && std::isfinite(smoothing))) {
    throw InputError(fmt::format("smoothing = {}: must be a finite number >= 0", smoothing));
  }
  if (samples > most_samples) {
    throw InputError(fmt::format("samples = {}: must be at most {}", samples, most_samples));
  }
  const Scene scene = resolved_in_time(asked);
  Recording recording;
  recording.fidelity = scene.fidelity;
  const double spacing = samples > 0 ? duration_of(scene) / static_cast<double>(samples)
                                     : std::numeric_limits<double>::infinity();
  Recorder recorder(scene, recording, spacing);
  Neighbours neighbours(scene);
  try {
    recording.end = neighbours.simulate_with(scene, recorder);
  } catch (const TimeLimitReached&) {
    recording.complete = false;
    recording.end = recorder.last();
  }
  const auto weigh = [&](double z, double left) {
    recording.count += static_cast<int>(weight(z, left, 0.0));
    recording.surrogate += weight(z, left, smoothing);
  };
  Features<double, decltype(weigh)> features(scene, weigh);
  for (const Impact& i : recording.impacts) features.impact(i.time, i.wall, i.speed);
  for (const Peak& p : recording.peaks) features.peak(p.time, p.position);
  try {
    if (!recording.complete) throw TimeLimitReached();
    recording.certainty = certainty_of(scene, recorder.trace(), neighbours);
  } catch (const TimeLimitReached&) {
    recording.certainty = unfinished(recording, duration_of(scene));
  }
  return recording;
}

Recording simulate(const Scene& scene, double smoothing, std::size_t samples) {
  check(scene, "scene");
  if (!(smoothing > 0 && std::isfinite(smoothing))) {
    throw InputError(fmt::format("smoothing = {}: must be a finite number > 0", smoothing));
  }
  return record(scene, smoothing, samples);
}

std::vector<Feature> features_of(const Scene& scene, const Recording& recording) {
  bool counts = false;
  const auto note = [&counts](double z, double /*left*/) { counts |= step(z, 0.0) > 0; };
  Features<double, decltype(note)> judged(scene, note);
  std::vector<Feature> features;
  if (scene.rule == CountRule::impacts) {
    for (const Impact& impact : recording.impacts) {
      judged.impact(impact.time, impact.wall, impact.speed);
      const double wall = impact.wall == Wall::upper ? scene.wall_upper : scene.wall_lower;
      features.push_back({impact.time, wall, std::exchange(counts, false)});
    }
  } else {
    for (const Peak& peak : recording.peaks) {
      judged.peak(peak.time, peak.position);
      features.push_back({peak.time, peak.position, std::exchange(counts, false)});
    }
  }
  return features;
}

std::vector<Feature> counted_features(const Scene& scene, const Recording& recording) {
  std::vector<Feature> features = features_of(scene, recording);
  std::erase_if(features, [](const Feature& feature) { return !feature.counts; });
  return features;
}

std::optional<Stretch> busiest_stretch(const Scene& scene, const Recording& recording) {
  std::vector<double> times;
  for (const Feature& feature : counted_features(scene, recording)) times.push_back(feature.time);
  if (times.size() < 3) return std::nullopt;
  const std::size_t most = (2 * times.size() + 2) / 3;
  Stretch best{times.front(), times.back()};
  for (std::size_t k = 0; k + most <= times.size(); ++k) {
    if (times[k + most - 1] - times[k] < best.to - best.from)
      best = {times[k], times[k + most - 1]};
  }
  const double duration = duration_of(scene);
  const double margin = std::max(0.25 * (best.to - best.from), 1e-3 * duration);
  best = {std::max(0.0, best.from - margin), std::min(duration, best.to + margin)};
  return best.to - best.from < duration / 4 ? std::optional(best) : std::nullopt;
}

}  // namespace ricochet::carrier_track::inline counting
