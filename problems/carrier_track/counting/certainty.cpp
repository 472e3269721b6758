#include "problems/carrier_track/counting/certainty.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "problems/carrier_track/scene/perturbation.h"
#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline counting {
namespace {

using Feature = FeatureTrace::Feature;

/// Features of two simulations are the same if they differ by at most this in the scaled margin and
/// by at most Neighbour::same_time in time.
constexpr double same_margin = 0.1;

/// A path with this growth or more is sensitive: perturbation_size then changes a scaled margin by
/// a hundredth of same_margin.
constexpr double sensitive_growth = 1e6;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Finds for the features of another simulation the same features of this one, for one kind. Call
/// of() in order of time.
class Counterparts {
 public:
  Counterparts(const std::vector<Feature>& others, double duration)
      : others_(others), within_(Neighbour::same_time * duration) {}

  /// Returns the feature nearest in time, if it is the same feature; else nullptr.
  const Feature* of(const Feature& feature) {
    while (after_ != others_.end() && after_->time < feature.time) ++after_;
    const Feature* best = after_ != others_.end() ? &*after_ : nullptr;
    if (after_ != others_.begin()) {
      const Feature& before = *std::prev(after_);
      if (best == nullptr || feature.time - before.time < best->time - feature.time) best = &before;
    }
    if (best == nullptr || std::abs(best->time - feature.time) > within_ ||
        std::abs(best->scaled - feature.scaled) > same_margin) {
      return nullptr;
    }
    return best;
  }

 private:
  const std::vector<Feature>& others_;
  double within_;  // [s]
  std::vector<Feature>::const_iterator after_ = others_.begin();
};

/// A feature of which it is in doubt whether it counts.
struct Suspect {
  double time = infinity;  ///< [s]
  std::size_t kind = 0;
  double margin = 0;
  Doubt doubt = Doubt::none;
  double left = 0;  ///< [s], time to the end of the window
};

/// A feature that occurs in both traces.
struct Pair {
  double time;  ///< [s]
  double change;
};

/// Compares a trace with that of a slightly different scene.
class Comparison {
 public:
  Comparison(const FeatureTrace& given, double given_end, const FeatureTrace& other,
             double other_end) {
    for (std::size_t kind = 0; kind < FeatureTrace::kinds; ++kind) {
      compare(kind, given.features(kind), given_end, other.features(kind), other_end);
    }
    for (std::size_t kind = 0; kind < FeatureTrace::kinds; ++kind) {
      find_near_end(kind, given.features(kind), given_end);
      find_near_end(kind, other.features(kind), other_end);
    }
  }

  const Suspect& first() const { return first_; }
  const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  void compare(std::size_t kind, const std::vector<Feature>& given, double given_end,
               const std::vector<Feature>& others, double other_end) {
    Counterparts in_others(others, given_end);
    for (const Feature& f : given) {
      const Feature* other = in_others.of(f);
      if (other == nullptr) {
        if (f.counts()) suspect(kind, f, Doubt::graze, given_end);
        continue;
      }
      const double change = std::abs(other->scaled - f.scaled);
      pairs_.push_back({f.time, change});
      moved_ = std::max(moved_, std::abs(other->time / other_end - f.time / given_end));
      if (std::abs(f.scaled) <= std::max(change, perturbation_size)) {
        suspect(kind, f, Doubt::margin, given_end);
      }
    }
    Counterparts in_given(given, given_end);
    for (const Feature& f : others) {
      if (f.counts() && f.time < other_end && in_given.of(f) == nullptr) {
        suspect(kind, f, Doubt::graze, other_end);
      }
    }
  }

  /// Uses ten times the largest movement, because the movement of an impact just after the end,
  /// which the given trace lacks, is unknown.
  void find_near_end(std::size_t kind, const std::vector<Feature>& features, double end) {
    for (auto f = features.rbegin(); f != features.rend(); ++f) {
      if (f->time < (1 - Neighbour::same_time) * end) break;
      if (f->counts() &&
          std::abs(end - f->time) <= 10 * end * std::max(moved_, perturbation_size)) {
        suspect(kind, *f, Doubt::window, end);
      }
    }
  }

  void suspect(std::size_t kind, const Feature& f, Doubt doubt, double end) {
    const bool near_end = std::abs(end - f.time) <= Neighbour::same_time * end;
    if (doubt == Doubt::graze && near_end) doubt = Doubt::window;
    if (f.time < first_.time) first_ = {f.time, kind, f.margin(), doubt, end - f.time};
  }

  Suspect first_;
  std::vector<Pair> pairs_;
  double moved_ = 0;  // largest movement of a feature in time, as a share of the window
};

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
      break;  // the same for all changed scenes
    case Doubt::sensitive:
      return fmt::format("a change in the tenth digit grows {:.2g}-fold by {:.6g} s", growth,
                         s.time);
  }
  return "";
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
  Suspect first;
  std::optional<Graze> graze;
  bool graze_is_given = false;
  std::vector<Pair> pairs;
  for (const Neighbour& near : neighbours.simulated()) {
    try {
      if (near.failure) std::rethrow_exception(near.failure);
    } catch (const std::runtime_error& error) {
      return give_up(Doubt::sensitive,
                     fmt::format("with the tenth digit changed {}", error.what()));
    }
    const FeatureTrace& other = near.trace;
    const Comparison comparison(trace, duration, other, near.end);
    pairs.insert(pairs.end(), comparison.pairs().begin(), comparison.pairs().end());
    const Suspect& suspect = comparison.first();
    if (suspect.time < first.time) first = suspect;
    if (graze) continue;
    graze = touched(trace, other, duration);
    graze_is_given = graze.has_value();
    if (!graze) graze = touched(other, trace, duration);
  }
  for (const Pair& pair : pairs) {
    if (pair.time > first.time) continue;
    certainty.growth = std::max(certainty.growth, pair.change / perturbation_size);
  }
  if (first.doubt == Doubt::none) return certainty;
  if (graze && graze->time > first.time + Neighbour::same_time * duration) graze.reset();
  if (graze) {
    first.doubt = Doubt::graze;
  } else if (certainty.growth >= sensitive_growth) {
    first.doubt = Doubt::sensitive;
  }
  return give_up(first.doubt, sentence(scene, first, graze, graze_is_given, certainty.growth));
}

}  // namespace ricochet::carrier_track::inline counting
