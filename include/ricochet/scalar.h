#pragma once

#include <concepts>
#include <cstddef>

/// Traits of a scalar that may be a dual number: its plain value, its derivatives, and how deeply
/// duals are nested. A dual is any type like ceres::Jet, with a real part `a` and DIMENSION
/// derivatives `v`, all of one type.
namespace ricochet::carrier_track::inline scene {

template <class T>
concept Dual = requires(T x) {
  x.a;
  x.v;
};

/// The type of a dual's real part: double, or a dual of one order less.
template <Dual T>
using Inner = decltype(T::a);

template <std::floating_point T>
double value(T x) {
  return static_cast<double>(x);
}

template <Dual T>
double value(const T& x) {
  return value(x.a);
}

/// 0 for double, 1 for a dual, 2 for a dual of duals: the order of the derivatives carried.
template <class T>
struct DerivativeOrder {
  static constexpr int value = 0;
};

template <Dual T>
struct DerivativeOrder<T> {
  static constexpr int value = 1 + DerivativeOrder<Inner<T>>::value;
};

/// Number of Newton steps that refine an event time found in double to the accuracy of T: one for
/// each order of derivatives, and two for a type with more digits.
template <class T>
inline constexpr int newton_steps = std::same_as<T, double> ? 0
                                    : Dual<T>               ? DerivativeOrder<T>::value
                                                            : 2;

/// A constant as a scalar of type T; duals of duals cannot be converted from double directly.
template <class T>
T constant(double x) {
  if constexpr (Dual<T>) {
    return T(constant<Inner<T>>(x));
  } else {
    return x;
  }
}

template <class T>
bool is_constant(const T& x);

/// Returns true if x and all its derivatives are zero. A quantity whose value alone is zero still
/// affects derivatives.
template <class T>
bool vanishes(const T& x) {
  if constexpr (Dual<T>) {
    return vanishes(x.a) && is_constant(x);
  } else {
    return x == 0;
  }
}

/// Returns true if x has no derivatives of the outermost order.
template <class T>
bool is_constant(const T& x) {
  if constexpr (Dual<T>) {
    for (int i = 0; i < T::DIMENSION; ++i) {
      if (!vanishes(x.v[i])) return false;
    }
  }
  return true;
}

/// x times a plain number, without the products by zero that a constant of type T costs.
template <class T>
T scaled(const T& x, double by) {
  if constexpr (Dual<T>) {
    T result;
    result.a = scaled(x.a, by);
    for (int i = 0; i < T::DIMENSION; ++i) result.v[i] = scaled(x.v[i], by);
    return result;
  } else {
    return x * by;
  }
}

}  // namespace ricochet::carrier_track::inline scene
