#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/oracle/comparison.h"
#include "src/report/json.h"

namespace ricochet::studies::verification {

/// What many comparisons with the oracle amount to.
class SceneTally {
 public:
  explicit SceneTally(std::string name) : name_(std::move(name)) {}

  void add(const carrier_track::Comparison& comparison);

  /// Comparisons that the oracle did not break off.
  int compared() const { return scenes_ - broken_off_; }

  /// name; scenes, broken_off (by the oracle, at its cap); certain, a share of those compared;
  /// wrong_certain and wrong_uncertain, wrong counts called certain and others; and of scenes
  /// called certain: missed, spurious and matched fast impacts, time_error [s] and speed_error
  /// [m/s], the largest where all impacts match.
  report::Json data() const;

 private:
  std::string name_;
  int scenes_ = 0, broken_off_ = 0, certain_ = 0, wrong_certain_ = 0, wrong_uncertain_ = 0;
  int missed_ = 0, spurious_ = 0, matched_ = 0;
  double time_error_ = 0, speed_error_ = 0;
};

}  // namespace ricochet::studies::verification
