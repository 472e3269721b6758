#pragma once

#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>

/// Boost.Odeint's rosenbrock4 with a corrected coefficient. NOTE: plain C++17; it does not compile
/// as C++20.
namespace ricochet::carrier_track::rosenbrock {

namespace odeint = boost::numeric::odeint;

// NOTE: up to Boost 1.74 at least, d4 of the method (Hairer and Wanner's RODAS) has the wrong sign,
// which leaves order 2 if the forces depend on time. This member hides it.
struct Coefficients : odeint::default_rosenbrock_coefficients<double> {
  const double d4 = -0.3620000000000023e-01;
};

using Method = odeint::rosenbrock4<double, Coefficients>;
using Vector = Method::state_type;
using Matrix = Method::matrix_type;
using Controller = odeint::rosenbrock4_controller<Method>;

}  // namespace ricochet::carrier_track::rosenbrock
