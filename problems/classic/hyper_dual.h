#pragma once

#include <Eigen/Core>
#include <cmath>

/// Second derivatives of formulas.
namespace ricochet::classic {

/// A hyper-dual number value + first e1 + other e2 + mixed e1 e2 with e1^2 = e2^2 = 0: `mixed` of
/// f(x + p e1 + q e2) is the second derivative of f along p and q, exact but for rounding (Fike and
/// Alonso 2011, doi:10.2514/6.2011-886).
struct HyperDual {
  double value = 0, first = 0, other = 0, mixed = 0;

  HyperDual() = default;
  HyperDual(double constant) : value(constant) {}  // NOLINT(google-explicit-constructor): a number
  HyperDual(double v, double e1, double e2, double e12)
      : value(v), first(e1), other(e2), mixed(e12) {}

  HyperDual& operator+=(const HyperDual& x) { return *this = *this + x; }
  HyperDual& operator-=(const HyperDual& x) { return *this = *this - x; }
  HyperDual& operator*=(const HyperDual& x) { return *this = *this * x; }
  HyperDual& operator/=(const HyperDual& x) { return *this = *this / x; }

  friend HyperDual operator+(const HyperDual& x, const HyperDual& y) {
    return {x.value + y.value, x.first + y.first, x.other + y.other, x.mixed + y.mixed};
  }
  friend HyperDual operator-(const HyperDual& x) {
    return {-x.value, -x.first, -x.other, -x.mixed};
  }
  friend HyperDual operator-(const HyperDual& x, const HyperDual& y) { return x + -y; }
  friend HyperDual operator*(const HyperDual& x, const HyperDual& y) {
    return {x.value * y.value, x.first * y.value + x.value * y.first,
            x.other * y.value + x.value * y.other,
            x.mixed * y.value + x.first * y.other + x.other * y.first + x.value * y.mixed};
  }
  friend HyperDual operator/(const HyperDual& x, const HyperDual& y) {
    const double inverse = 1 / y.value;
    const double square = inverse * inverse;
    return x * y.chained(inverse, -square, 2 * square * inverse);
  }
  friend bool operator==(const HyperDual& x, const HyperDual& y) { return x.value == y.value; }
  friend auto operator<=>(const HyperDual& x, const HyperDual& y) { return x.value <=> y.value; }

  /// f(x) of a function with this value and these derivatives at x.value.
  HyperDual chained(double f, double slope, double curvature) const {
    return {f, slope * first, slope * other, slope * mixed + curvature * first * other};
  }
};

inline HyperDual sqrt(const HyperDual& x) {
  const double root = std::sqrt(x.value);
  return x.chained(root, 0.5 / root, -0.25 / (root * x.value));
}
inline HyperDual exp(const HyperDual& x) {
  const double power = std::exp(x.value);
  return x.chained(power, power, power);
}
inline HyperDual log(const HyperDual& x) {
  return x.chained(std::log(x.value), 1 / x.value, -1 / (x.value * x.value));
}
inline HyperDual sin(const HyperDual& x) {
  return x.chained(std::sin(x.value), std::cos(x.value), -std::sin(x.value));
}
inline HyperDual cos(const HyperDual& x) {
  return x.chained(std::cos(x.value), -std::sin(x.value), -std::cos(x.value));
}
inline HyperDual abs(const HyperDual& x) {
  return x.value < 0 ? -x : x;
}
inline HyperDual asin(const HyperDual& x) {
  const double slope = 1 / std::sqrt(1 - x.value * x.value);
  return x.chained(std::asin(x.value), slope, x.value * slope * slope * slope);
}
inline HyperDual atan(const HyperDual& x) {
  const double slope = 1 / (1 + x.value * x.value);
  return x.chained(std::atan(x.value), slope, -2 * x.value * slope * slope);
}
/// The angle of (x, y), as std::atan2.
inline HyperDual atan2(const HyperDual& y, const HyperDual& x) {
  HyperDual angle = std::abs(x.value) >= std::abs(y.value) ? atan(y / x) : -atan(x / y);
  angle.value = std::atan2(y.value, x.value);
  return angle;
}
inline HyperDual pow(const HyperDual& x, double power) {
  return x.chained(std::pow(x.value, power), power * std::pow(x.value, power - 1),
                   power * (power - 1) * std::pow(x.value, power - 2));
}
/// Of x > 0.
inline HyperDual pow(const HyperDual& x, const HyperDual& power) {
  return exp(power * log(x));
}
inline HyperDual cbrt(const HyperDual& x) {
  const double root = std::cbrt(x.value);
  const double slope = root / (3 * x.value);
  return x.chained(root, slope, -2 * slope / (3 * x.value));
}

}  // namespace ricochet::classic

template <>
struct Eigen::NumTraits<ricochet::classic::HyperDual> : Eigen::NumTraits<double> {
  using Real = ricochet::classic::HyperDual;
  using NonInteger = ricochet::classic::HyperDual;
  using Nested = ricochet::classic::HyperDual;
  using Literal = ricochet::classic::HyperDual;
  enum { RequireInitialization = 1 };  // NOLINT(readability-identifier-naming): Eigen's
};

template <class Operation>
struct Eigen::ScalarBinaryOpTraits<ricochet::classic::HyperDual, double, Operation> {
  using ReturnType = ricochet::classic::HyperDual;
};

template <class Operation>
struct Eigen::ScalarBinaryOpTraits<double, ricochet::classic::HyperDual, Operation> {
  using ReturnType = ricochet::classic::HyperDual;
};
