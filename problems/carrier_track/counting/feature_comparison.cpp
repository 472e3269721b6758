#include "problems/carrier_track/counting/feature_comparison.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "problems/carrier_track/counting/neighbours.h"

namespace ricochet::carrier_track::inline counting {
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
