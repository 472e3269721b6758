#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ricochet/families.h"
#include "ricochet/problem.h"
#include "src/report/json.h"

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
  std::vector<Outlier> outliers;       ///< the unexplained first, then by falling relative error
};

/// In parallel, with the same bits for any number of threads.
DerivativeCheckStudy study_derivative_check(const DerivativeCheckPlan& plan);

/// Of a study that compared something.
report::Json data_of(const DerivativeCheckStudy& study);

}  // namespace ricochet::studies::surrogate
