#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/report/json.h"

/// How far the surrogate's answers are from those of the count, at every smoothing width.
namespace ricochet::studies::surrogate {

struct BiasPlan {
  double step;                 ///< [rad/s] of the speeds looked at, up to 18 rad/s
  std::vector<double> widths;  ///< from wide to narrow
};

/// One case at one width.
struct Bias {
  double width;
  double error;                            ///< mean |surrogate - count| over the speeds
  std::optional<double> rank_correlation;  ///< Spearman's; nothing where one of them is constant
  double count_regret;  ///< count where the surrogate is lowest, above the lowest count
  /// The fastest speed at which the surrogate is quiet, and what it misses of the fastest at which
  /// the count is [rad/s], below 0 where it is faster. Nothing where the surrogate is never quiet.
  std::optional<double> speed, speed_regret;
  bool loud = false;  ///< whether the count is loud at that speed
};

struct CaseBias {
  std::string id;
  int lowest;      ///< count
  double fastest;  ///< [rad/s], at which the count is quiet
  std::vector<Bias> biases;
};

struct BiasStudy {
  BiasPlan plan;
  std::vector<CaseBias> cases;
};

/// Every case of the paper in the default reading.
BiasStudy study_bias(const BiasPlan& plan);

report::Json data_of(const BiasStudy& study);

}  // namespace ricochet::studies::surrogate
