#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"
#include "src/research/paper/loss.h"
#include "src/research/paper/unknown_parameters.h"

namespace ricochet::studies::variants {

/// Values of all parameters of a variant.
struct VariantConstants {
  carrier_track::Constants base;  ///< those of the interpretation that it changes
  std::vector<double> own;        ///< one for each of its own parameters
};

/// When a simulation may stop.
struct EarlyStopping {
  int most = std::numeric_limits<int>::max();  ///< higher counts are taken as one more than this
  /// Share of the counting limit: a body that rebounds slower may rest. 0: resting_speed_of.
  double resting_share = 0;
};

/// For a search, as in loss.h.
inline constexpr EarlyStopping searching = {carrier_track::most_counted, 0.01};
/// For an evaluation.
inline constexpr EarlyStopping judging = {};

/// A model variant that is not in paper/interpretation.h: one of those interpretations, its base,
/// with a change that no Interpretation and no Scene can express.
struct ModelVariant {
  std::string name;                          ///< e.g. "press-of-y"
  std::string description;                   ///< a sentence
  carrier_track::Interpretation base;        ///< that it changes
  std::vector<carrier_track::Unknown> free;  ///< parameters of the base that a search may change
  std::vector<carrier_track::UnknownParameter> own;  ///< and those that the variant adds; natural:
                                                     ///< where a search begins
  /// True if it is integrated step by step, at 100 times the cost of a simulation, or is the
  /// reference of such a variant: its searches have few evaluations.
  bool brief = false;

  /// The counts of a case at any speed, for the parameters, which are copied.
  std::function<carrier_track::CountAt(const carrier_track::Case&, const VariantConstants&,
                                       const EarlyStopping&)>
      counts = {};
  /// Of the base, where a search begins; empty: see start_of.
  std::optional<carrier_track::Constants> start = {};
};

/// Start of a search: the variant's own; else the natural values; for a brief variant the
/// parameters of the default interpretation.
VariantConstants start_of(const ModelVariant& variant);

/// The loss (loss.h) of a variant.
double loss_of(const ModelVariant& variant, const VariantConstants& constants);

}  // namespace ricochet::studies::variants
