#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/random.h"
#include "src/report/results.h"

/// Are the derivatives correct? Compares exact ones with differences, at random points of every
/// problem.
namespace ricochet::studies::surrogate {

/// Relative errors above this are outliers, whose cause is determined.
inline constexpr double outlier = 1e-6;

/// A slope below this share of the function's magnitude, or of 1, across the whole box is
/// negligible, and so is an error below it.
inline constexpr double nothing = 1e-9;

/// The steps of the differences: at most this, in a box of width 1.
inline constexpr double first_step = 1e-3;

/// Why a difference does not equal an exact derivative.
enum class Cause {
  none,         ///< not an outlier
  flat,         ///< the two differ by a negligible amount
  reach,        ///< its steps exceeded the gradient's reach; shorter ones agree
  rounding,     ///< by less than 1e-3, and no more than differences vary
  unexplained,  ///< unknown
};
inline constexpr std::size_t causes = 5;

/// One function of a problem, its objective or a constraint, at one point in one direction.
struct Comparison {
  std::size_t problem;
  double exact;       ///< derivative along the direction, in a box of width 1
  double difference;  ///< the same by extrapolated differences
  double error;       ///< estimated, of the difference
  Trust trust;
  Cause cause;

  /// Error of the difference, relative to the larger of the two; 0 if they are equal.
  double relative() const;
};

/// Compares all functions of `problem`, which has derivatives, at a point in the unit box along a
/// direction of length 1: the objective, then the constraints. `point` must be at least first_step
/// away from the box's faces.
std::vector<Comparison> compare(const Problem& problem, const Vector& point,
                                const Vector& direction);

struct DerivativeCheckPlan {
  std::vector<Family> families;  ///< their problems without derivatives are skipped
  std::size_t points;            ///< in total, distributed evenly over the families
  std::uint64_t seed;
};

/// For one function of the problems of a family.
struct DerivativeErrors {
  std::string family;
  std::string function;  ///< "objective" or "constraints"
  std::size_t points = 0;
  std::vector<double> errors;  ///< relative, rising: one for each function and point
  std::array<std::size_t, causes> by_cause{};
};

/// An outlier with its details.
struct Outlier {
  std::string problem;
  Comparison comparison;
  Vector point;  ///< in the problem's own units
};

struct DerivativeCheckStudy {
  std::size_t points = 0;
  std::size_t families = 0;
  std::uint64_t seed = 0;
  std::vector<DerivativeErrors> rows;  ///< for each family its objective, then its constraints
  std::vector<Outlier> unexplained;
};

/// In parallel, with the same bits for any number of threads.
DerivativeCheckStudy study_derivative_check(const DerivativeCheckPlan& plan);

/// Adds the tables derivatives and unexplained, and the values that the page's section names. Of a
/// study that compared something.
void add_to(report::Results& results, const DerivativeCheckStudy& study);

// Where is the surrogate's gradient meaningful? Over all cases and speeds.

struct GradientDoubtPlan {
  int cells;                       ///< of the range of speeds, for the maps
  int points;                      ///< in a cell
  std::vector<double> smoothings;  ///< with default_smoothing, of which the map is
  std::vector<double> steps;       ///< of differences, as shares of the range of speeds
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

struct GradientDoubtStudy {
  GradientDoubtPlan plan;
  std::vector<CaseQuality> rows;              ///< at default_smoothing
  std::vector<GradientQuality> by_smoothing;  ///< of all cases
};

GradientDoubtStudy study_gradient_doubt(const GradientDoubtPlan& plan);

/// Adds the table validity, the chart validity-trend, and the values that the page's section names.
void add_to(report::Results& results, const GradientDoubtStudy& study);

/// Uniform in [a, b), from the generator's bits only: the same on every platform.
inline double within(Random& random, double a, double b) {
  return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53;
}

}  // namespace ricochet::studies::surrogate
