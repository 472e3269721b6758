#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "src/report/json.h"

/// Where the surrogate's gradient means something: over every case and the speeds.
namespace ricochet::studies::surrogate {

struct GradientDoubtPlan {
  int cells;                   ///< of the range of speeds, for the maps
  int points;                  ///< in a cell
  std::vector<double> widths;  ///< for the table; the maps are of default_width
  std::vector<double> steps;   ///< of differences, as parts of the range of speeds, falling
};

/// What the gradient is worth at points of one cell, or of one width.
struct GradientQuality {
  int points = 0;
  int agreeing = 0;  ///< with differences of some step, to 1e-6
  int trending =
      0;          ///< points about which the count rises or falls at all, and the gradient is not 0
  int right = 0;  ///< of those, points where the gradient has the sign of the count's trend
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

struct GradientDoubtStudy {
  GradientDoubtPlan plan;
  std::vector<CaseQuality> rows;
  std::vector<GradientQuality> by_width;  ///< of all cases
  std::vector<StepError> step_errors;
};

GradientDoubtStudy study_gradient_doubt(const GradientDoubtPlan& plan);

report::Json data_of(const GradientDoubtStudy& study);

}  // namespace ricochet::studies::surrogate
