#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "src/report/json.h"

/// Where is the surrogate's gradient meaningful? Over all cases and speeds.
namespace ricochet::studies::surrogate {

struct GradientDoubtPlan {
  int cells;                       ///< of the range of speeds, for the maps
  int points;                      ///< in a cell
  std::vector<double> smoothings;  ///< for the table; the maps are of default_smoothing
  std::vector<double> steps;       ///< of differences, as shares of the range of speeds, falling
};

/// Quality of the gradient at points of one cell, or of one smoothing parameter.
struct GradientQuality {
  int points = 0;
  int agreeing = 0;  ///< with differences of any of the steps, to 1e-6
  int trending = 0;  ///< points where the count has a trend and the gradient is not 0
  int right = 0;     ///< of those, points where the gradient has the sign of the count's trend
  std::array<int, 4> doubts{};  ///< by GradientDoubt
  double log_reach = 0;         ///< median of log10(reach)
};

struct CaseQuality {
  std::string id;
  std::vector<GradientQuality> cells;  ///< by speed
};

/// Relative error of central differences of one step, over all points.
struct StepError {
  double step;
  double median, upper;  ///< the latter the 0.9 quantile
};
RICOCHET_WRITTEN_AS_JSON(StepError, step, median, upper);

struct GradientDoubtStudy {
  GradientDoubtPlan plan;
  std::vector<CaseQuality> rows;
  GradientQuality all;                        ///< of all cases
  std::vector<GradientQuality> by_smoothing;  ///< of all cases
  std::vector<StepError> step_errors;
};

GradientDoubtStudy study_gradient_doubt(const GradientDoubtPlan& plan);

report::Json data_of(const GradientDoubtStudy& study);

}  // namespace ricochet::studies::surrogate
