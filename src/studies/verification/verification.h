#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/check/oracle.h"
#include "src/report/site/study.h"

namespace ricochet::studies::verification {

/// Summary of many comparisons with the oracle.
struct SceneTally {
  std::string name;
  int scenes = 0;
  int broken_off = 0;       ///< stopped by the oracle's cap
  double certain = 0;       ///< share of those compared
  int wrong_certain = 0;    ///< wrong counts called certain
  int wrong_uncertain = 0;  ///< wrong counts not called certain
  // Fast impacts of scenes called certain:
  int missed = 0, spurious = 0, matched = 0;
  double time_error = 0, speed_error = 0;  ///< [s], [m/s], the largest where all impacts match
  int called_certain = 0;

  void add(const carrier_track::Comparison& comparison);

  /// Comparisons that the oracle did not break off.
  int compared() const { return scenes - broken_off; }
};

}  // namespace ricochet::studies::verification

namespace ricochet::studies {

struct VerificationOptions {
  int scenes = 10000;  ///< 1..100,000,000
  int seed = 1;
};

/// Compares the impact model with the oracle: over random and hostile scenes, and over the quiet
/// speeds of every case. Its result `failed` is true if a count called certain is wrong. Throws
/// InputError for a number of scenes out of range.
Study verification_study(const VerificationOptions& options);

}  // namespace ricochet::studies
