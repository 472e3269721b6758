#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/report/results.h"
#include "src/report/site/study.h"

namespace ricochet::studies {

/// How far can the surrogate and its gradient be trusted? Takes some minutes on two
/// processors.
Study surrogate_study();

}  // namespace ricochet::studies

/// Surrogate bias: how far the surrogate's optima are from those of the count, at every smoothing
/// parameter.
namespace ricochet::studies::surrogate {

struct BiasPlan {
  double step;                     ///< [rad/s] between the speeds, up to 18 rad/s
  std::vector<double> smoothings;  ///< from wide to narrow
};

/// One case at one smoothing parameter.
struct Bias {
  double smoothing;
  double error;                            ///< mean |surrogate - count| over the speeds
  std::optional<double> rank_correlation;  ///< Spearman's; nothing if one of them is constant
  double count_optimality_gap;  ///< count at the surrogate's minimum, minus the lowest count
  /// The fastest speed at which the surrogate is quiet, and the fastest at which the count is minus
  /// this speed [rad/s], below 0 if the surrogate's is faster. Nothing if the surrogate is never
  /// quiet.
  std::optional<double> speed, speed_optimality_gap;
  bool loud = false;  ///< whether the count is loud at that speed
};

struct CaseBias {
  std::string id;
  int lowest;      ///< count
  double fastest;  ///< [rad/s] at which the count is quiet
  std::vector<Bias> biases;
};

struct BiasStudy {
  BiasPlan plan;
  std::vector<CaseBias> cases;
};

/// Every case of the paper in the default interpretation.
BiasStudy study_bias(const BiasPlan& plan);

/// Adds the finding, the tables bias (a row for each case and smoothing parameter) and quiet-speeds
/// (a row for each case), and the chart speed-gap.
void add_to(report::Results& results, const BiasStudy& study);

}  // namespace ricochet::studies::surrogate
