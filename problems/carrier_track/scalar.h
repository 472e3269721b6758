#pragma once

/// The two things generic code must know of a scalar that may be a dual number: its plain value,
/// and how deeply duals are nested. A dual is any type with a real part `a`, such as ceres::Jet.
namespace ricochet::carrier_track {

template <class T>
concept Dual = requires(T x) {
  x.a;
};

inline double value(double x) {
  return x;
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
  static constexpr int value = 1 + DerivativeOrder<decltype(T::a)>::value;
};

/// A constant as a scalar of type T; duals of duals have no conversion of their own from double.
template <class T>
T constant(double x) {
  if constexpr (Dual<T>) {
    return T(constant<decltype(T::a)>(x));
  } else {
    return x;
  }
}

}  // namespace ricochet::carrier_track
