#include "problems/carrier_track/counting/certainty.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "problems/carrier_track/counting/feature_comparison.h"
#include "problems/carrier_track/scene/perturbation.h"
#include "ricochet/recording.h"

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

}  // namespace ricochet::carrier_track::inline counting
