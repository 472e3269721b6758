#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "problems/family.h"
#include "src/core/problem.h"
#include "src/report/json.h"

/// Are the derivatives right? Exact ones beside differences, at random points of every problem.
namespace ricochet::studies::surrogate {

/// Relative errors above this are outliers, and want a cause.
inline constexpr double outlier = 1e-6;

/// A slope below this share of the function's size, or of 1, across the whole box is next to
/// nothing, and so is an error below it.
inline constexpr double nothing = 1e-9;

/// The steps of the differences: this and less, in a box of width 1.
inline constexpr double first_step = 1e-3;

/// Why a difference is not equal to an exact derivative.
enum class Cause {
  none,         ///< it is: no outlier
  flat,         ///< the two differ by next to nothing
  reach,        ///< its steps led over the gradient's reach; shorter ones agree
  rounding,     ///< by less than 1e-3, and no more than differences differ among themselves
  unexplained,  ///< nobody knows
};
inline constexpr std::size_t causes = 5;

/// One function of a problem, its objective or a constraint, at one point in one direction.
struct Comparison {
  std::size_t problem;
  double exact;       ///< derivative along the direction, in a box of width 1
  double difference;  ///< the same by extrapolated differences
  double error;       ///< that the difference is estimated to have
  Trust trust;
  Cause cause;

  /// Of the difference from the exact derivative, relative to the larger; 0 where they are equal.
  double relative() const;
};

/// Everything that `problem`, which has derivatives, says at a point in the unit box, along a
/// direction of length 1: the objective, then the constraints. `point` must be first_step away from
/// the box's faces.
std::vector<Comparison> compare(const Problem& problem, const Vector& point,
                                const Vector& direction);

struct DerivativeCheckPlan {
  std::vector<Family> families;  ///< their questions without derivatives are passed over
  std::size_t points;            ///< in all, shared out evenly to the families
  std::uint64_t seed;
};

/// Of one function of the problems of a family.
struct DerivativeErrors {
  std::string family;
  std::string function;  ///< "objective" or "constraints"
  std::size_t points = 0;
  std::vector<double> errors;  ///< relative, rising: one a function and point
  std::array<std::size_t, causes> by_cause{};
};

/// An outlier, to be looked at.
struct Outlier {
  std::string problem;
  Comparison comparison;
  Vector point;  ///< in the problem's own units
};

struct DerivativeCheckStudy {
  std::size_t points = 0;
  std::size_t families = 0;
  std::uint64_t seed = 0;
  std::vector<DerivativeErrors> rows;  ///< of each family its objective, then its constraints
  std::vector<Outlier> outliers;       ///< the unexplained first, then by falling relative error
};

/// In parallel, with the same bits for any number of threads.
DerivativeCheckStudy study_derivative_check(const DerivativeCheckPlan& plan);

/// Of a study that compared something.
report::Json data_of(const DerivativeCheckStudy& study);

}  // namespace ricochet::studies::surrogate
