#pragma once

#include <limits>
#include <vector>

#include "problems/carrier_track/counting/feature_trace.h"
#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline counting {

/// A feature of which it is in doubt whether it counts.
struct Suspect {
  double time = std::numeric_limits<double>::infinity();  ///< [s]
  std::size_t kind = 0;                                   ///< a FeatureTrace::Kind
  double margin = 0;
  Doubt doubt = Doubt::none;
  double left = 0;  ///< [s], time to the end of the window
};

/// A feature that occurs in both traces.
struct FeaturePair {
  double time;    ///< [s], in the given trace
  double change;  ///< absolute difference of the scaled margins
};

/// Compares the features of a simulation with those of a slightly different scene, one by one.
class FeatureComparison {
 public:
  /// The ends [s] are those of the scenes' windows.
  FeatureComparison(const FeatureTrace& given, double given_end, const FeatureTrace& other,
                    double other_end);

  /// The first feature in doubt; Doubt::none if there is none.
  const Suspect& first() const { return first_; }
  const std::vector<FeaturePair>& pairs() const { return pairs_; }

  /// Returns true if everything is further from starting or stopping to count than
  /// `clear_factor` times the largest change of anything: then the opposite of the small difference
  /// cannot raise a doubt either, since to first order it changes everything by the opposite.
  bool is_clear() const { return is_clear_; }

  static constexpr double clear_factor = 100;

 private:
  using List = std::vector<FeatureTrace::Feature>;

  void compare(std::size_t kind, const List& given, double given_end, const List& others,
               double other_end);
  void find_near_end(std::size_t kind, const List& features, double end);
  void suspect(std::size_t kind, const FeatureTrace::Feature& f, Doubt doubt, double end);
  bool is_clear(const FeatureTrace& given, const FeatureTrace& other) const;

  Suspect first_;
  std::vector<FeaturePair> pairs_;
  double moved_ = 0;    // largest movement of a feature in time, as a share of the window
  double changed_ = 0;  // largest change of a pair
  double nearest_ = 1;  // smallest |scaled margin| of a given feature
  bool is_clear_ = false;
};

}  // namespace ricochet::carrier_track::inline counting
