#include "problems/carrier_track/counting/certainty.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline counting {

namespace {

using Feature = FeatureTrace::Feature;

/// A path with this growth or more is sensitive: perturbation_size then changes a scaled margin by
/// a hundredth of the largest difference of features that are the same.
constexpr double sensitive_growth = 1e6;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool has_impact(const FeatureTrace& trace, const Graze& graze, double duration) {
  const std::vector<double>& times = trace.impacts(graze.wall);
  const auto first =
      std::lower_bound(times.begin(), times.end(), graze.time - Neighbour::same_time * duration);
  return first != times.end() && *first <= graze.time + Neighbour::same_time * duration;
}

/// Returns the nearest graze of `one` if it is an impact in `other`.
std::optional<Graze> touched(const FeatureTrace& one, const FeatureTrace& other, double duration) {
  const std::optional<Graze>& graze = one.graze();
  if (!graze || has_impact(one, *graze, duration) || !has_impact(other, *graze, duration)) {
    return std::nullopt;
  }
  return graze;
}

std::string limit_sentence(const Scene& scene, const Suspect& s) {
  if (s.kind < FeatureTrace::high_peak) {
    return fmt::format("an impact at {:.6g} s is within {:.2g} m/s of the slowest that counts",
                       s.time, scene.counting_limit * std::abs(std::expm1(s.margin)));
  }
  const double limit = s.kind == FeatureTrace::high_peak ? scene.peak_high : scene.peak_low;
  return fmt::format("a maximum at {:.6g} s is within {:.2g} m of the limit from which it counts",
                     s.time, limit * std::abs(s.margin));
}

std::string graze_sentence(const Graze& graze, bool given) {
  const char* wall = graze.wall == Wall::upper ? "upper" : "lower";
  if (given) {
    return fmt::format("at {:.6g} s the carrier misses the {} wall by {:.2g} m", graze.time, wall,
                       graze.distance);
  }
  return fmt::format(
      "at {:.6g} s the carrier touches the {} wall, and with the tenth digit misses it by {:.2g} m",
      graze.time, wall, graze.distance);
}

std::string unsure_sentence(const char* what, double time) {
  return fmt::format("{} that counts, at {:.6g} s, is there or not with the tenth digit", what,
                     time);
}

std::string endless_sentence(const FeatureTrace::Endless& endless) {
  return fmt::format(
      "from {:.6g} s on maxima count that never end, of ever smaller hops or swings at the {} wall",
      endless.time, endless.wall == Wall::upper ? "upper" : "lower");
}

std::string sentence(const Scene& scene, const Suspect& s, const std::optional<Graze>& graze,
                     bool graze_is_given, double growth) {
  const char* what = s.kind < FeatureTrace::high_peak ? "an impact" : "a maximum";
  switch (s.doubt) {
    case Doubt::none:
      return "";
    case Doubt::margin:
      return limit_sentence(scene, s);
    case Doubt::window:
      return fmt::format("{} at {:.6g} s is within {:.2g} s of the end of the window", what, s.time,
                         std::abs(s.left));
    case Doubt::graze:
      return graze ? graze_sentence(*graze, graze_is_given) : unsure_sentence(what, s.time);
    case Doubt::endless:
    case Doubt::unfinished:
      break;  // the same for all changed scenes
    case Doubt::sensitive:
      return fmt::format("a change in the tenth digit grows {:.2g}-fold by {:.6g} s", growth,
                         s.time);
  }
  return "";
}

/// The largest change up to a time [s], in units of perturbation_size.
double growth_of(const std::vector<FeaturePair>& pairs, double until) {
  double largest = 0;
  for (const FeaturePair& pair : pairs) {
    if (pair.time <= until) largest = std::max(largest, pair.change);
  }
  return largest / perturbation_size;
}

/// The growth if all these neighbours are clear of doubts; else nothing.
std::optional<double> clear_growth(const FeatureTrace& trace, double duration,
                                   const std::array<const Neighbour*, 2>& side) {
  double growth = 0;
  for (const Neighbour* near : side) {
    if (near->failure) return std::nullopt;
    const FeatureComparison comparison(trace, duration, near->trace, near->end);
    if (!comparison.is_clear()) return std::nullopt;
    growth = std::max(growth, growth_of(comparison.pairs(), infinity));
  }
  return growth;
}

/// Margins increase with the scaled ones, so that two logarithms are enough.
std::optional<double> smallest_margin(const FeatureTrace& trace) {
  const Feature* above = nullptr;
  const Feature* below = nullptr;
  for (std::size_t kind = 0; kind < FeatureTrace::kinds; ++kind) {
    for (const Feature& f : trace.features(kind)) {
      const Feature*& nearest = f.counts() ? above : below;
      if (nearest == nullptr || std::abs(f.scaled) < std::abs(nearest->scaled)) nearest = &f;
    }
  }
  std::optional<double> margin;
  for (const Feature* f : {above, below}) {
    if (f != nullptr) margin = std::min(margin.value_or(infinity), std::abs(f->margin()));
  }
  return margin;
}

}  // namespace

Certainty certainty_of(const Scene& scene, const FeatureTrace& trace, Neighbours& neighbours) {
  Certainty certainty;
  certainty.margin = smallest_margin(trace);
  certainty.graze = trace.graze();
  const auto give_up = [&certainty](Doubt doubt, std::string reason) {
    certainty.certain = false;
    certainty.doubt = doubt;
    certainty.reason = std::move(reason);
    return certainty;
  };
  if (trace.endless()) return give_up(Doubt::endless, endless_sentence(*trace.endless()));
  if (trace.shallow_peak())
    return give_up(Doubt::graze, unsure_sentence("a maximum", *trace.shallow_peak()));
  if (!trace.finite()) return give_up(Doubt::sensitive, "numbers overflow");
  const double duration = duration_of(scene);
  if (const auto growth = clear_growth(trace, duration, neighbours.one_side())) {
    certainty.growth = *growth;
    return certainty;
  }
  Suspect first;
  std::optional<Graze> graze;
  bool graze_is_given = false;
  std::vector<FeaturePair> pairs;
  for (const Neighbour& near : neighbours.all()) {
    try {
      if (near.failure) std::rethrow_exception(near.failure);
    } catch (const std::runtime_error& error) {
      return give_up(Doubt::sensitive,
                     fmt::format("with the tenth digit changed {}", error.what()));
    }
    const FeatureTrace& other = near.trace;
    const FeatureComparison comparison(trace, duration, other, near.end);
    pairs.insert(pairs.end(), comparison.pairs().begin(), comparison.pairs().end());
    const Suspect& suspect = comparison.first();
    if (suspect.time < first.time) first = suspect;
    if (graze) continue;
    graze = touched(trace, other, duration);
    graze_is_given = graze.has_value();
    if (!graze) graze = touched(other, trace, duration);
  }
  certainty.growth = growth_of(pairs, first.time);
  if (first.doubt == Doubt::none) return certainty;
  if (graze && graze->time > first.time + Neighbour::same_time * duration) graze.reset();
  if (graze) {
    first.doubt = Doubt::graze;
  } else if (certainty.growth >= sensitive_growth) {
    first.doubt = Doubt::sensitive;
  }
  return give_up(first.doubt, sentence(scene, first, graze, graze_is_given, certainty.growth));
}

namespace {

// Strides: the fractional parts of the golden ratio and of the square root of two.
constexpr double golden_stride = 0.6180339887498949;
constexpr double root_stride = 0.4142135623730950;

bool crosses(const Scene& scene) {
  return !(scene.wall_upper > scene.wall_lower) ||
         (scene.across && !(scene.across->wall_upper > scene.across->wall_lower));
}

}  // namespace

Neighbour::Neighbour(const Scene& given, double stride, double sign)
    : scene(perturbed(given, stride, sign)), end(duration_of(scene)), trace(scene) {
  std::visit([](auto& window) { window.count *= 1 + same_time; }, scene.window);
}

void Neighbour::end_with(const End<double>& last, std::exception_ptr thrown) {
  failure = std::move(thrown);
  if (!failure && (!trace.finite() || !std::isfinite(last.position + last.velocity))) {
    failure = std::make_exception_ptr(std::runtime_error("numbers overflow"));
  }
}

Neighbours::Neighbours(const Scene& scene)
    : all_{{{scene, golden_stride, +1},
            {scene, golden_stride, -1},
            {scene, root_stride, +1},
            {scene, root_stride, -1}}} {}

Neighbours::Side Neighbours::one_side() {
  simulate_side(0);
  return {&all_[0], &all_[2]};
}

const std::array<Neighbour, 4>& Neighbours::all() {
  simulate_side(0);
  if (!all_[0].failure) simulate_side(1);
  return all_;
}

void Neighbours::simulate_side(std::size_t side) {
  if (std::exchange(simulated_[side], true)) return;
  for (Neighbour* n : sound_ones(side)) {
    try {
      n->end_with(simulate(n->scene, n->trace), nullptr);
    } catch (const TimeLimitReached&) {
      throw;
    } catch (...) {
      n->failure = std::current_exception();
    }
    if (n->failure) break;
  }
}

std::vector<Neighbour*> Neighbours::sound_ones(std::size_t side) {
  std::vector<Neighbour*> sound;
  for (const std::size_t k : {side, side + 2}) {
    Neighbour& n = all_[k];
    if (crosses(n.scene)) {
      n.failure = std::make_exception_ptr(std::runtime_error("one wall crosses the other"));
    } else {
      sound.push_back(&n);
    }
  }
  return sound;
}

void FeatureTrace::impact(double time, Wall wall, double speed) {
  now_ = time;
  finite_ = finite_ && std::isfinite(time + speed);
  const std::size_t kind = wall == Wall::lower ? lower_impact : upper_impact;
  impacts_[kind].push_back(time);
  if (scene_.rule != CountRule::impacts || speed <= 0) return;
  const double counting_limit = scene_.counting_limit;
  tell(kind, is_counted(speed, counting_limit) ? impact_margin(speed, counting_limit)
                                               : speed / counting_limit - 1);
}

void FeatureTrace::peak(double time, double position) {
  // A maximum is reported when the body starts to move down from it, which is now.
  std::size_t kind = high_peak;
  const auto keep = [&](double z, double /*left*/) {
    tell(kind++, z > 0 ? z : std::expm1(z));
    counting_peak_ = counting_peak_ || (z > 0 && position < scene_.wall_upper);
  };
  Features<double, decltype(keep)>(scene_, keep).peak(time, position);
}

void FeatureTrace::hops(double time, Wall wall) {
  if (scene_.rule != CountRule::peaks || endless_) return;
  // Their maxima lie on the upper wall, or arbitrarily near the lower one.
  const double height = wall == Wall::upper ? scene_.wall_upper : scene_.wall_lower;
  if (height >= scene_.peak_high || height <= scene_.peak_low) endless_ = Endless{time, wall};
}

void FeatureTrace::contact(double time, double position, double velocity) {
  now_ = time;
  const bool upper = scene_.wall_upper - position < position - scene_.wall_lower;
  const double inward = upper ? velocity : -velocity;
  if (inward > 0 && swung_out_) hops(time, upper ? Wall::upper : Wall::lower);
  swung_out_ = swung_out_ || inward < 0;
}

double FeatureTrace::reach() const {
  double reach = 0;
  for (const double x : {scene_.wall_lower, scene_.wall_upper, scene_.start_position}) {
    if (std::isfinite(x)) reach = std::max(reach, std::abs(x));
  }
  return reach;
}

void FeatureTrace::tell(std::size_t kind, double scaled) {
  finite_ = finite_ && std::isfinite(now_ + scaled);
  features_[kind].push_back({now_, scaled});
}

void FeatureTrace::turn(double time, double position, Wall ahead) {
  finite_ = finite_ && std::isfinite(time + position);
  const double distance =
      ahead == Wall::upper ? scene_.wall_upper - position : position - scene_.wall_lower;
  if (!(distance > 0) || std::isinf(distance)) return;
  if (!graze_ || distance < graze_->distance) graze_ = Graze{time, ahead, distance};
}

namespace {

/// Features of two simulations are the same if they differ by at most this in the scaled margin and
/// by at most Neighbour::same_time in time.
constexpr double same_margin = 0.1;

/// Beyond this change the path is not nearly linear in its constants.
constexpr double small_change = 1e-4;

/// Finds for the features of another simulation the same features of this one, for one kind. Call
/// of() in order of time.
class Counterparts {
 public:
  Counterparts(const std::vector<FeatureTrace::Feature>& others, double duration)
      : others_(others), within_(Neighbour::same_time * duration) {}

  /// Returns the feature nearest in time, if it is the same feature; else nullptr.
  const FeatureTrace::Feature* of(const FeatureTrace::Feature& feature) {
    while (after_ != others_.end() && after_->time < feature.time) ++after_;
    const FeatureTrace::Feature* best = after_ != others_.end() ? &*after_ : nullptr;
    if (after_ != others_.begin()) {
      const FeatureTrace::Feature& before = *std::prev(after_);
      if (best == nullptr || feature.time - before.time < best->time - feature.time) best = &before;
    }
    if (best == nullptr || std::abs(best->time - feature.time) > within_ ||
        std::abs(best->scaled - feature.scaled) > same_margin) {
      return nullptr;
    }
    return best;
  }

 private:
  const std::vector<FeatureTrace::Feature>& others_;
  double within_;  // [s]
  std::vector<FeatureTrace::Feature>::const_iterator after_ = others_.begin();
};

}  // namespace

FeatureComparison::FeatureComparison(const FeatureTrace& given, double given_end,
                                     const FeatureTrace& other, double other_end) {
  for (std::size_t kind = 0; kind < FeatureTrace::kinds; ++kind) {
    compare(kind, given.features(kind), given_end, other.features(kind), other_end);
  }
  is_clear_ = is_clear(given, other);
  for (std::size_t kind = 0; kind < FeatureTrace::kinds; ++kind) {
    find_near_end(kind, given.features(kind), given_end);
    find_near_end(kind, other.features(kind), other_end);
  }
  is_clear_ = is_clear_ && first_.doubt == Doubt::none;
}

void FeatureComparison::compare(std::size_t kind, const List& given, double given_end,
                                const List& others, double other_end) {
  Counterparts in_others(others, given_end);
  for (const FeatureTrace::Feature& f : given) {
    nearest_ = std::min(nearest_, std::abs(f.scaled));
    const FeatureTrace::Feature* other = in_others.of(f);
    if (other == nullptr) {
      if (f.counts()) suspect(kind, f, Doubt::graze, given_end);
      continue;
    }
    const double change = std::abs(other->scaled - f.scaled);
    pairs_.push_back({f.time, change});
    changed_ = std::max(changed_, change);
    moved_ = std::max(moved_, std::abs(other->time / other_end - f.time / given_end));
    if (std::abs(f.scaled) <= std::max(change, perturbation_size)) {
      suspect(kind, f, Doubt::margin, given_end);
    }
  }
  Counterparts in_given(given, given_end);
  for (const FeatureTrace::Feature& f : others) {
    if (f.counts() && f.time < other_end && in_given.of(f) == nullptr) {
      suspect(kind, f, Doubt::graze, other_end);
    }
  }
}

/// Uses ten times the largest movement, because the movement of an impact just after the end, which
/// the given trace lacks, is unknown.
void FeatureComparison::find_near_end(std::size_t kind, const List& features, double end) {
  for (auto f = features.rbegin(); f != features.rend(); ++f) {
    if (f->time < (1 - Neighbour::same_time) * end) break;
    if (!f->counts()) continue;
    const double left = std::abs(end - f->time);
    const double near = 10 * end * std::max(moved_, perturbation_size);
    if (left <= near) suspect(kind, *f, Doubt::window, end);
    is_clear_ = is_clear_ && left > clear_factor * near;
  }
}

void FeatureComparison::suspect(std::size_t kind, const FeatureTrace::Feature& f, Doubt doubt,
                                double end) {
  const bool near_end = std::abs(end - f.time) <= Neighbour::same_time * end;
  if (doubt == Doubt::graze && near_end) doubt = Doubt::window;
  if (f.time < first_.time) first_ = {f.time, kind, f.margin(), doubt, end - f.time};
}

bool FeatureComparison::is_clear(const FeatureTrace& given, const FeatureTrace& other) const {
  const double change = std::max({changed_, moved_, perturbation_size});
  if (change > small_change || nearest_ <= clear_factor * change) return false;
  const auto& here = given.graze();
  const auto& there = other.graze();
  if (!here && !there) return true;
  if (!here || !there || here->wall != there->wall) return false;
  // A path that misses a wall moves with the walls, too, by a share of the coordinates.
  const double shift = std::abs(here->distance - there->distance) + change * given.reach();
  return here->distance > clear_factor * shift;
}

}  // namespace ricochet::carrier_track::inline counting
